// SPDX-License-Identifier: Apache-2.0
#include "guidance/wall_needs.h"

#include <algorithm>
#include <vector>

#include "planner/rules/evading.h"
#include "planner/stages/certify.h"
#include "planner/stages/demands.h"
#include "robots/model.h"

namespace avo::inline guidance {

void WallNeeds::include(const RobotTraits& robot, double stray, double speed, const StepLaw& law) {
  const double radius = robot.radius, max_speed = robot.max_speed;
  const Ability ability = ability_of(robot);
  const WallRounding own = wall_rounding(radius, max_speed, ability, law);
  rounding = {std::max(rounding.steps, own.steps), std::max(rounding.lengths, own.lengths)};
  const double top_speed = std::max(max_speed, speed);
  reach = std::max(
      reach, radius + stray + wall_reach(top_speed, max_speed, planned_ability_of(robot), law));
}

void WallNeeds::include(const Robot& robot, const RobotTraits& traits, const Planner& planner) {
  const double speed = norm(robot.velocity);
  const PlannerOptions& options = planner.options();
  const StepLaw law = certificate_law(planner).step;
  const double stray =
      traits.has_model ? stray_of(robot.model, traits.max_acceleration, law.time_step).distance +
                             room_to_turn(robot.model, traits.max_speed)
                       : 0.0;
  // from where the robot takes itself to be
  include(traits, stray + 2.0 * law.localization_error, speed, law);
  const double wished =
      method_traits(options.method).has_rules
          ? std::min(options.wall_range, evasion_range(robot))
          : obstacle_reach(std::max(speed, traits.max_speed), traits.max_speed, options);
  const double maneuvers =
      traits.has_model ? model_traits(robot.model).maneuver_room + law.localization_error : 0.0;
  reach = std::max(reach, traits.radius + std::max(wished, maneuvers));
}

bool WallNeeds::cover(const WallNeeds& needs) const {
  return needs.reach <= reach && needs.rounding.steps <= rounding.steps &&
         needs.rounding.lengths <= rounding.lengths;
}

WallGrid grid_of(std::span<const Wall> walls, const WallNeeds& needs) {
  constexpr double kRounding = 0x1p-20;  // of a length, more than the grid's own arithmetic hides
  std::vector<double> within;
  within.reserve(walls.size());
  for (const Wall& wall : walls) {
    const double exact = needs.reach + wall.radius + wall_margin(wall, needs.rounding);
    within.push_back(exact * (1.0 + kRounding));
  }
  return {walls, within};
}

}  // namespace avo::inline guidance
