// SPDX-License-Identifier: Apache-2.0
#include "sim/goals.h"

#include "core/scalar.h"
#include "sim/goals_kernel.h"

namespace avo {
GoalLaw goal_law(const Planner& planner) {
  const PlannerOptions& options = planner.options();
  return {options.method, options.time_step, options.control_time, planner.step_rate(),
          planner.step_lag()};
}

Vec2 preferred_velocity(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
                        const GoalLaw& law) {
  using Real = scalar::Pack<double>;
  const scalar::Traveller<Real> traveller{
      scalar::constant<Real>(position), scalar::constant<Real>(velocity),
      scalar::constant<Real>(goal),     robot.preferred_speed,
      robot.max_acceleration,           robot.max_speed};
  const scalar::Vec<Real> v =
      scalar::preferred_velocity(traveller, scalar::way_of(traveller, law), law);
  return {v.x.value, v.y.value};
}

}  // namespace avo
