// SPDX-License-Identifier: Apache-2.0
// The robots of a tile in columns: what they do on their own, in lanes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "robots/motion.h"
#include "sim/goals.h"

namespace avo {

/// With ten neighbors each, what is planned at a time stays in the cache; not more than a mask has
/// bits.
inline constexpr std::size_t kTileRobots = 64;

struct alignas(64) MovingColumns {
  using Column = std::array<double, kTileRobots>;
  std::size_t count = 0;
  Column x{}, y{}, v_x{}, v_y{}, goal_x{}, goal_y{};  // m, m/s
  Column preferred_speed{}, max_acceleration{}, max_speed{};

  Column distance{};                    // m, to the goal; by choose_ways()
  Column preferred_x{}, preferred_y{};  // m/s, likewise
  Column new_x{}, new_y{};              // m/s, v'
  Column acceleration{};                // m/s^2, see MotionStep; by advance()

  Vec2 position(std::size_t k) const { return {x[k], y[k]}; }
  Vec2 velocity(std::size_t k) const { return {v_x[k], v_y[k]}; }
  void set(std::size_t k, Vec2 position, Vec2 velocity, Vec2 goal, const RobotTraits& traits) {
    x[k] = position.x, y[k] = position.y;
    v_x[k] = velocity.x, v_y[k] = velocity.y;
    goal_x[k] = goal.x, goal_y[k] = goal.y;
    preferred_speed[k] = traits.preferred_speed;
    max_acceleration[k] = traits.max_acceleration;
    max_speed[k] = traits.max_speed;
  }
};

/// preferred_velocity() of all, and how far they are from their goals.
void choose_ways(const GoalLaw& law, MovingColumns& robots);

/// advance() of all, from v' on. Bit k is set where robot k then exceeds its max_speed.
std::uint64_t advance(const StepResponse& response, MovingColumns& robots);

struct MovingKernels {
  void (*choose_ways)(const GoalLaw&, MovingColumns&);
  std::uint64_t (*advance)(const StepResponse&, MovingColumns&);
};

}  // namespace avo
