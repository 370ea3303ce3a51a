// SPDX-License-Identifier: Apache-2.0
#include "planner/methods/clamped.h"

#include <algorithm>

#include "core/plane.h"

namespace avo::inline planner {

Plan clamped(const Planner& planner, const Robot& robot, const Plan& plan,
             std::span<const HalfPlane> half_planes) {
  const PlannerOptions& options = planner.options();
  const double most = robot.max_acceleration * options.time_step;
  const Vec2 reached = approach(robot.velocity, plan.new_velocity, most);
  if (reached == plan.new_velocity) return plan;
  double worst = plan.violation;
  for (const HalfPlane& plane : half_planes) worst = std::max(worst, violation(plane, reached));
  return plan_of(options, robot.velocity, reached, status_of(worst), worst);
}

PassiveChoice clamped(const PassiveChoice& choice, const Robot& robot, double time_step,
                      std::span<const Limit> limits) {
  const double most = robot.max_acceleration * time_step;
  PassiveChoice result = choice;
  result.velocity = approach(robot.velocity, choice.velocity, most);
  if (result.velocity == choice.velocity) return choice;
  for (const Limit& limit : limits) {
    if (limit.kind != Limit::Kind::disc)
      result.violation = std::max(result.violation, violation(limit, result.velocity));
  }
  if (result.violation > 0.0) result.state = PassiveState::least_unsafe;
  return result;
}

}  // namespace avo::inline planner
