// SPDX-License-Identifier: Apache-2.0
// The preferred velocities and the motion of a tile's robots, in lanes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/robot_columns.h"
#include "guidance/goals.h"
#include "robots/motion.h"

namespace avo::inline sim {

/// With ten neighbors each, the data of one tile stay in the cache; a mask must have as many bits.
inline constexpr std::size_t kTileRobots = 64;

/// One entry for each robot, beside RobotColumns: the values that only a simulation knows.
struct alignas(64) MovingColumns {
  using Column = std::array<double, kTileRobots>;
  Column goal_x{}, goal_y{}, preferred_speed{};  // m, m/s
  Column new_x{}, new_y{};                       // m/s, v'
  Column acceleration{};                         // m/s^2, see MotionStep; set by advance()
};

/// preferred_velocity() of all robots, and their distances from their goals.
void choose_preferred(const StepResponse& step, const MovingColumns& moving, RobotColumns& robots);

/// advance() of all robots, from v' on. Bit k is set where robot k then exceeds its max_speed.
std::uint64_t advance(const StepResponse& response, MovingColumns& moving, RobotColumns& robots);

}  // namespace avo::inline sim
