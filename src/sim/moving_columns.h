// SPDX-License-Identifier: Apache-2.0
// The ways and the motion of a tile's robots, in lanes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/robot_columns.h"
#include "robots/motion.h"
#include "sim/fleet.h"

namespace avo::inline sim {

/// With ten neighbors each, what is planned at a time stays in the cache; not more than a mask has
/// bits.
inline constexpr std::size_t kTileRobots = 64;

/// One entry a robot, beside RobotColumns: what a simulation alone knows.
struct alignas(64) MovingColumns {
  using Column = std::array<double, kTileRobots>;
  Column goal_x{}, goal_y{}, preferred_speed{};  // m, m/s
  Column new_x{}, new_y{};                       // m/s, v'
  Column acceleration{};                         // m/s^2, see MotionStep; by advance()
};

/// [v_A^pref] m/s: towards the goal at preferred_speed (the paper's), until the distance left is
/// the one that braking needs; then the v' whose next speed is the highest that still stops at the
/// goal. Without other robots it comes to rest on the goal, does not overshoot and does not
/// oscillate, at any δ: v' leads the velocity by the lag of the controller, so near the goal it
/// points away from it.
Vec2 preferred_velocity(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
                        const StepResponse& step);

/// preferred_velocity() of all, and how far they are from their goals.
void choose_ways(const StepResponse& step, const MovingColumns& moving, RobotColumns& robots);

/// advance() of all, from v' on. Bit k is set where robot k then exceeds its max_speed.
std::uint64_t advance(const StepResponse& response, MovingColumns& moving, RobotColumns& robots);

}  // namespace avo::inline sim
