// SPDX-License-Identifier: Apache-2.0
#include "guidance/rules/held_passages.h"

#include "navigation/prospect.h"
#include "planner/rules/arrival.h"

namespace avo::inline guidance {

double unit_of_time(const RobotTraits& traits) {
  Robot robot;
  robot.radius = traits.route_radius;
  robot.max_speed = traits.max_speed, robot.max_acceleration = traits.max_acceleration;
  return time_to_speed(robot);
}

std::optional<Passages::Crossing> gap_ahead(const Routes& routes, const Travel& travel, Vec2 p) {
  return next_gap(routes.passages, *travel.graph, *travel.map, p, travel.target);
}

}  // namespace avo::inline guidance
