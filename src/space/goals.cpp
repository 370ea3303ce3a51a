// SPDX-License-Identifier: Apache-2.0
#include "space/goals.h"

#include <algorithm>
#include <cmath>

#include "guidance/goals_kernel.h"
#include "space/own_space.h"

namespace avo::space {

using Number = scalar::Pack<double>;

namespace {

// Returns whether the goal is farther away than rounding can tell. The first test needs no root.
bool is_away(double distance, Vec3 place, Vec3 goal) {
  const auto around = one_norm(scalar::constant<Number>(place)).value +
                      one_norm(scalar::constant<Number>(goal)).value;
  return distance > 0x1p-45 * around || distance > 0x1p-46 * (norm(place) + norm(goal));
}

}  // namespace

Vec3 preferred_velocity(const Robot& robot, Vec3 goal, double preferred_speed,
                        const Landing& landing, const Tempo& tempo) {
  const Vec3 to_goal = goal - robot.position;
  const double distance = norm(to_goal);
  if (!is_away(distance, robot.position, goal)) return {};
  const Vec3 direction = to_goal / distance;
  const ResponseLaw& law = landing.law;
  // along the route a robot brakes with b/ν, and is as fast as v_max/ν
  const double per_own = 1.0 / own_length(direction, robot.vertical);
  double top = std::min(preferred_speed, robot.max_speed * per_own);
  if (direction.z > 0.0) top = std::min(top, robot.climb / direction.z);
  if (direction.z < 0.0) top = std::min(top, -robot.sink / direction.z);
  const double left = distance - landing.lag * dot(robot.velocity, direction);
  const double braking = tempo.used_braking * per_own;
  const double time_step = law.time_step;
  if (!law.is_gentle()) {
    const Number hard = scalar::admissible_speed(
        Number(left), Number(braking * landing.braking_time), Number(time_step));
    return std::min(hard.value, top) * direction;
  }
  const Number response(tempo.response_time), decrement(braking * landing.braking_time);
  const auto known = scalar::surely_admits(Number(left) - Number(top) * response, Number(top),
                                           decrement, Number(time_step));
  if (known.bit) return top * direction;
  const Number soft =
      scalar::soft_speed(Number(left), Number(braking * landing.braking_time / time_step), response,
                         Number(time_step));
  return std::min(soft.value, top) * direction;
}

}  // namespace avo::space
