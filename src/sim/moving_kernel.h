// SPDX-License-Identifier: Apache-2.0
// Kernels over the columns of a tile: the preferred velocities of Eqs. (14), (23), and the motion
// of Eqs. (7)-(9).
#ifndef AVO_SIM_MOVING_KERNEL_H
#define AVO_SIM_MOVING_KERNEL_H

#include <cstddef>
#include <cstdint>

#include "guidance/goals_kernel.h"
#include "planner/stages/relevance.h"
#include "robots/holonomic_kernel.h"
#include "sim/columns/moving_columns.h"

AVO_BEGIN_KERNELS

template <typename Real>
void choose_preferred(const StepResponse& step, const MovingColumns& moving, RobotColumns& robots) {
  static_assert(kTileRobots % Real::kLanes == 0);
  for (std::size_t k = 0; k < robots.count; k += Real::kLanes) {
    const auto load = [k](const auto& column) { return Real::load(&column[k]); };
    alignas(64) double holonomic[Real::kLanes];
    for (std::size_t lane = 0; lane < Real::kLanes; ++lane)
      holonomic[lane] =
          robots.has_models && k + lane < robots.count && robots.model[k + lane] != nullptr ? 0.0
                                                                                            : 1.0;
    const Traveller<Real> robot{{load(robots.x), load(robots.y)},
                                {load(robots.v_x), load(robots.v_y)},
                                {load(moving.goal_x), load(moving.goal_y)},
                                load(moving.preferred_speed),
                                min(load(robots.max_acceleration), load(robots.max_braking)),
                                load(robots.max_speed),
                                load(robots.max_acceleration),
                                Real::load(holonomic)};
    const GoalLine<Real> line = line_to_goal(robot, step);
    line.distance.store(&robots.distance_to_goal[k]);
    const Vec<Real> v = preferred_velocity(robot, line, step);
    v.x.store(&robots.preferred_x[k]), v.y.store(&robots.preferred_y[k]);
  }
}

template <typename Real>
std::uint64_t advance(const StepResponse& response, MovingColumns& moving, RobotColumns& robots) {
  std::uint64_t fast = 0;
  for (std::size_t k = 0; k < robots.count; k += Real::kLanes) {
    const auto load = [k](const auto& column) { return Real::load(&column[k]); };
    const Moved<Real> next =
        moved<Real>({load(robots.x), load(robots.y)}, {load(robots.v_x), load(robots.v_y)},
                    {load(moving.new_x), load(moving.new_y)}, response);
    next.position.x.store(&robots.x[k]), next.position.y.store(&robots.y[k]);
    next.velocity.x.store(&robots.v_x[k]), next.velocity.y.store(&robots.v_y[k]);
    next.acceleration.store(&moving.acceleration[k]);
    const Real limit = Real(1.0 + kSpeedRounding) * load(robots.max_speed);
    const auto keeps = dot(next.velocity, next.velocity) <= limit * limit;
    fast |= std::uint64_t{bits(!keeps)} << k;
  }
  return robots.count == 0 ? 0 : fast & ~std::uint64_t{0} >> (kTileRobots - robots.count);
}

AVO_END_KERNELS

#endif  // once per pass
