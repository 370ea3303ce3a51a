// SPDX-License-Identifier: Apache-2.0
// Who has not arrived, and who is in the way.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/metrics.h"

namespace avo {

/// Columns of a fleet as last seen, and of the moving obstacles then.
struct LastSeen {
  std::vector<RobotId> id;
  std::vector<Vec2> position, velocity, goal;
  std::vector<double> radius;
  std::vector<PlanStatus> status;
  std::vector<double> detour;  // rad
  std::vector<Vec2> obstacle_position, obstacle_velocity;
  std::vector<double> obstacle_radius;

  void look_at(const Simulation& simulation);
  [[nodiscard]] NotArrived describe(std::size_t robot) const;
};

}  // namespace avo
