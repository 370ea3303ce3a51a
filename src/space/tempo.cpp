// SPDX-License-Identifier: Apache-2.0
#include "space/tempo.h"

#include <algorithm>
#include <limits>

#include "core/response_law_kernel.h"
#include "planner/rules/arrival.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

using Number = scalar::Pack<double>;

// m: see is_landing()
double landing_distance(const avo::Robot& robot, const Haste& haste, const Execution& execution) {
  if (haste.gain >= 1.0) return -std::numeric_limits<double>::infinity();
  const double braking = std::min(planned_braking(robot), haste.most / execution.braking_time);
  const double stopping = 0.5 * robot.max_speed * robot.max_speed / braking;
  return stopping + 2.0 * (execution.law.time_step / haste.gain) * robot.max_speed;
}

}  // namespace

Tempo tempo_of(const Robot& robot, const Landing& planner) {
  const Execution execution{planner.law, planner.braking_time, true};
  avo::Robot far = numbers_of(robot);
  far.distance_to_goal = std::numeric_limits<double>::infinity();
  const Number speed(robot.max_speed), acceleration(robot.max_acceleration);
  const double usual = scalar::usual_response_time(speed, acceleration, planner.law).value;
  const Number braking = scalar::used_of(Number(planned_braking(robot)), speed, planner.law);
  Tempo tempo;
  tempo.haste = haste_of(far, execution);
  tempo.there = std::max(robot.radius, robot.max_speed * usual);
  tempo.landing = landing_distance(far, tempo.haste, execution);
  tempo.unhurried = std::min(unhurried_part(far, execution), 1.0);
  tempo.traffic_range = arrival_range(far, 0.0);
  tempo.time_to_speed = time_to_speed(far);
  tempo.used_braking = braking.value;
  tempo.response_time = scalar::response_time(speed, acceleration, braking, planner.law).value;
  return tempo;
}

Haste haste_at(const Tempo& tempo, double distance_to_goal, bool remembers) {
  Haste haste = tempo.haste;
  if (!remembers || distance_to_goal < tempo.there) haste.jerk = kUnlimited;
  return haste;
}

}  // namespace avo::space
