// SPDX-License-Identifier: Apache-2.0
// Who has not arrived, and who is in the way.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "avo/metrics.h"

namespace avo {

/// A fleet as last seen, by ascending id, and the moving obstacles then.
struct LastSeen {
  struct Robot {
    RobotId id;
    Vec2 position, velocity, goal;
    double heading;  // rad, of those that have one
    double radius;
    PlanStatus status;
    double detour;  // rad
    LayerSet layers, avoids;
    bool parked;
    std::optional<Simulation::Wait> wait;  // of one at rest
  };
  struct Obstacle {
    Vec2 position, velocity;
    double radius;
  };
  std::vector<Robot> robots;
  std::vector<Obstacle> obstacles;

  void look_at(const Simulation& simulation);
  [[nodiscard]] NotArrived describe(std::size_t robot) const;
};

}  // namespace avo
