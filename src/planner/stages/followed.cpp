// SPDX-License-Identifier: Apache-2.0
// The robot's motion for a plan: how it brakes, what it can follow, and the velocity that it then
// has.
#include <algorithm>
#include <optional>

#include "core/plane.h"
#include "planner/decision.h"
#include "planner/methods/flight.h"
#include "planner/options.h"
#include "planner/stages/certify.h"
#include "planner/validity.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// v' that comes to rest within the step if the limits allow, and otherwise brakes straight along
// -v, Eq. (7); |v' - v| <= δ b always, |v'| <= v_max unless that is farther than δ b away. rate:
// the part of v' - v that one step turns into velocity.
Vec2 braking_velocity(const Robot& robot, double control_time, double rate) noexcept {
  const double speed = norm(robot.velocity);
  if (!(speed > 0.0)) return {};
  const double limit = control_time * braking_limit(robot);
  const double change = std::min({speed / rate, limit, std::max(speed + robot.max_speed, 0.0)});
  return ((speed - change) / speed) * robot.velocity;
}

// A robot that flies can hold its speed and turn right. That is its only choice where a number is
// wrong, at any place. If its place or its circle is unknown, it acts as if it were at the origin.
std::optional<Robot> flying(const Robot& robot, double time_step) {
  if (!can_brake(robot) || !can_drive(robot)) return std::nullopt;
  if (has_known_place(robot) && can_fly(robot, time_step)) return robot;
  Robot anywhere = robot;
  anywhere.position = {}, anywhere.loiter = {};
  return can_fly(anywhere, time_step) ? std::optional(anywhere) : std::nullopt;
}

}  // namespace

Plan brake(const Planner& planner, const Robot& robot, PlanStatus status, double violation) {
  if (!can_brake(robot)) return {.status = PlanStatus::invalid_input};
  const PlannerOptions& options = planner.options();
  if (!can_rest(robot.model)) {
    const auto flown = flying(robot, options.time_step);
    return flown ? loiter_on(planner, *flown, status, violation)
                 : Plan{.status = PlanStatus::invalid_input};
  }
  if (adopts_at_once(options.method))
    return plan_of(options, robot.velocity, {}, status, violation);
  if (goes_through_certificate(options)) {
    const CertificateLaw law = certificate_law(planner);
    return plan_under(law, robot, backup_velocity(robot, law), status, violation);
  }
  return plan_of(options, robot.velocity,
                 braking_velocity(robot, options.control_time, planner.step_rate()), status,
                 violation);
}

Plan as_followed(const Planner& planner, const Robot& robot, Plan plan) {
  const PlannerOptions& options = planner.options();
  if (options.certificate != Certificate::none ||
      !model_traits(robot.model).has_limits_within_steps || !can_brake(robot) || !can_drive(robot))
    return plan;
  const double time_step = options.time_step;
  const Vec2 wanted = robot.velocity + time_step * plan.acceleration;
  const Vec2 v = within_own_limits(robot, time_step, wanted);
  if (v == wanted) return plan;
  plan.acceleration = (v - robot.velocity) / time_step;
  const double control_time = adopts_at_once(options.method) ? time_step : options.control_time;
  plan.new_velocity = robot.velocity + control_time * plan.acceleration;
  return plan;
}

Plan with_next_velocity(const Planner& planner, const Robot& robot, Plan plan) {
  if (!can_brake(robot)) return plan;
  if (!is_holonomic(robot.model) && can_drive(robot) && follows_heading(robot)) {
    MotionState state{{}, robot.velocity, robot.heading};
    if (!can_rest(robot.model)) {
      const auto flown = flying(robot, planner.options().time_step);
      if (!flown) return plan;
      state.position = flown->position, state.circle = *with_circle(*flown).loiter;
    }
    const MotionLimits limits{planned_braking(robot), robot.max_speed};
    plan.next_velocity =
        advance(robot.model, limits, state, plan, planner.options().time_step).next.velocity;
  } else {
    plan.next_velocity = advance({{}, robot.velocity}, plan, step_response(planner)).next.velocity;
  }
  return plan;
}

}  // namespace avo::inline planner
