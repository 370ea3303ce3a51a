// SPDX-License-Identifier: Apache-2.0
// The command that takes off as much speed as one step can, Eq. (7).
#include "planner/braking.h"

#include <algorithm>

namespace avo {

Vec2 braking_velocity(const Robot& robot, double control_time, double rate) noexcept {
  const double speed = norm(robot.velocity);
  if (!(speed > 0.0)) return {};
  const double limit = control_time * robot.max_acceleration;
  const double change = std::min({speed / rate, limit, std::max(speed + robot.max_speed, 0.0)});
  return ((speed - change) / speed) * robot.velocity;
}

}  // namespace avo
