// SPDX-License-Identifier: Apache-2.0
// The robots that have not arrived, and the robots that block them.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/metrics.h"

namespace avo::inline metrics {

/// A fleet as last seen, by ascending id, and the moving obstacles then.
struct LastSeen {
  std::vector<RobotId> id;
  std::vector<Vec2> position, velocity, goal;
  std::vector<double> heading;  // rad, of robots that have one
  std::vector<PlanStatus> status;
  std::vector<double> detour;          // rad
  std::vector<Simulation::Wait> wait;  // of robots at rest that wait
  std::vector<std::size_t> waiting;    // indices of these robots, ascending
  struct Obstacle {
    Vec2 position, velocity;
    double radius;
  };
  std::vector<Obstacle> obstacles;

  void look_at(const Simulation& simulation, const FleetView& fleet);
  /// setups: of the robots last seen.
  [[nodiscard]] NotArrived describe(std::size_t robot, std::span<const RobotSetup> setups) const;
};

}  // namespace avo::inline metrics
