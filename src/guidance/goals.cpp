// SPDX-License-Identifier: Apache-2.0
#include "guidance/goals.h"

#include "guidance/goals_kernel.h"

namespace avo::inline guidance {

Vec2 preferred_velocity(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
                        const StepResponse& step) {
  using Real = scalar::Pack<double>;
  const scalar::Traveller<Real> traveller{
      scalar::constant<Real>(position), scalar::constant<Real>(velocity),
      scalar::constant<Real>(goal),     robot.preferred_speed,
      planned_braking(robot),           robot.max_speed,
      robot.max_acceleration,           robot.has_model ? 0.0 : 1.0};
  return plain(scalar::preferred_velocity(traveller, scalar::line_to_goal(traveller, step), step));
}

}  // namespace avo::inline guidance
