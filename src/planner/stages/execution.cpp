// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/execution.h"

#include <algorithm>

#include "certificate/braking_path.h"
#include "planner/execution_kernel.h"
#include "planner/stages/certify.h"

namespace avo::inline planner {
Execution execution_of(const Planner& planner, bool remembers) {
  return {.law = response_law(planner.options()),
          .braking_time = certificate_law(planner).step.braking_time,
          .remembers = remembers};
}

Haste haste_of(const Robot& robot, const Execution& execution) {
  using Real = scalar::Pack<double>;
  const auto haste = scalar::haste_of<Real>(robot.radius, robot.max_speed, robot.max_acceleration,
                                            robot.distance_to_goal, execution);
  return {haste.gain.value, haste.most.value, haste.jerk.value};
}

Haste haste_at_once(const Robot& robot, const Execution& execution) {
  const double used = std::min(robot.max_acceleration, execution.law.comfort_acceleration);
  return {1.0, execution.braking_time * used, kUnlimited};
}

double unhurried_part(const Robot& robot, const Execution& execution) {
  using Real = scalar::Pack<double>;
  const ResponseLaw& law = execution.law;
  if (!law.is_gentle()) return 1.0;
  const Real speed(robot.max_speed), acceleration(robot.max_acceleration);
  const Real used = scalar::used_of(acceleration, speed, law);
  const double time = scalar::response_time(speed, acceleration, used, law).value;
  const double usual = scalar::usual_response_time(speed, acceleration, law).value;
  return std::min(scalar::kUnhurried * (time / usual), 1.0);
}

Vec2 executed(Vec2 velocity, Vec2 last_change, Vec2 target, const Haste& haste) {
  using Real = scalar::Pack<double>;
  const auto in_lane = [](Vec2 a) { return scalar::constant<Real>(a); };
  return plain(scalar::executed(in_lane(velocity), in_lane(last_change), in_lane(target),
                                scalar::PackHaste<Real>{haste.gain, haste.most, haste.jerk}));
}

bool is_landing(const Robot& robot, const Haste& haste, const Execution& execution) {
  if (haste.gain >= 1.0) return false;
  const double braking = std::min(planned_braking(robot), haste.most / execution.braking_time);
  const double stopping = 0.5 * robot.max_speed * robot.max_speed / braking;
  const double response_time = execution.law.time_step / haste.gain;
  return robot.distance_to_goal < stopping + 2.0 * response_time * robot.max_speed;
}

void remember(const Plan& plan, Detour& detour) {
  detour.acceleration_x = static_cast<float>(plan.acceleration.x);
  detour.acceleration_y = static_cast<float>(plan.acceleration.y);
}

}  // namespace avo::inline planner
