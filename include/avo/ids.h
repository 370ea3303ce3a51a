// SPDX-License-Identifier: Apache-2.0
// Stable names of the bodies of a simulation; none is used again within it.
#pragma once
#include <cstdint>
#include <variant>

namespace avo {

/// Stable name of a robot; never reused within a simulation.
struct RobotId {
  std::uint64_t value = 0;  ///< robots of the scenario are 0, 1, ... in its order
  friend constexpr bool operator==(RobotId, RobotId) = default;
};

/// Stable name of a static obstacle; never reused within a simulation.
struct ObstacleId {
  std::uint64_t value = 0;  ///< obstacles of the scenario are 0, 1, ... in its order
  friend constexpr bool operator==(ObstacleId, ObstacleId) = default;
};

/// Stable name of a moving obstacle; never reused within a simulation.
struct MovingObstacleId {
  std::uint64_t value = 0;  ///< moving obstacles of the scenario are 0, 1, ... in its order
  friend constexpr bool operator==(MovingObstacleId, MovingObstacleId) = default;
};

/// Names a robot or a moving obstacle.
using BodyId = std::variant<RobotId, MovingObstacleId>;

}  // namespace avo
