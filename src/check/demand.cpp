// SPDX-License-Identifier: Apache-2.0
#include "check/demand.h"

#include <algorithm>
#include <cmath>

namespace avo::judge {

double demand_of(const Change& change, const Agility& ability, bool square) {
  const auto [slowing, across] = change;
  const auto [a, b] = ability;
  const double all = square ? std::max(std::abs(slowing), across) : norm(Vec2{slowing, across});
  if (!(b > a)) return all;
  if (square)  // beyond it, the side from its corner (a, a) to (b, 0)
    return slowing > a ? (a * slowing + (b - a) * across) / b : all;
  // the tangent from (b, 0) touches the disc in the direction (cosine, sine)
  const double cosine = a / b, sine = std::sqrt(1.0 - cosine * cosine);
  return across * cosine < slowing * sine ? slowing * cosine + across * sine : all;
}

double braking_of(const CheckedRobot& robot) {
  if (robot.parked) return 0.0;
  return std::max(robot.max_acceleration, robot.max_braking.value_or(0.0));
}

double longest_step(const CheckedRobot& robot, double duration) {
  return std::max(robot.time_step.value_or(0.0), duration);
}

double demand_of(const CheckedRobot& robot, double a_max, Vec2 before, Vec2 now, double duration) {
  const Vec2 change = now - before;
  const double b = braking_of(robot), step = longest_step(robot, duration);
  if (!(b > a_max)) return norm(change);
  // the farther back, the larger the part of a change against the velocity
  const Vec2 from = before - (step / duration - 1.0) * change;
  const double speed = norm(from);
  if (!(speed > 0.0)) return norm(change);
  const Agility ability{a_max * duration, std::min(b, speed / step) * duration};
  return demand_of({-dot(from, change) / speed, std::abs(cross(from, change)) / speed}, ability,
                   false);
}

}  // namespace avo::judge
