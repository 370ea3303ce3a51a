// SPDX-License-Identifier: Apache-2.0
#include "guidance/follower.h"

#include "guidance/rules/held_passages.h"

namespace avo::inline guidance {

Headings guide(const Routes& routes, const Claims& claims, const Follower& robot, double time_step,
               double sensing_radius, Travel& travel, LegScratch& scratch) {
  const Heading by_route = follow(travel, robot.place, robot.end, robot.traits, robot.own_path,
                                  robot.looks_around, scratch);
  Headings result{by_route, by_route};
  Heading& heading = result.heading;
  if (!routes.passages.empty()) {
    const bool in_company = is_in_company(robot.traits.radius, robot.nearest);
    const double left = norm(heading.goal - robot.place);
    heading = heed_passages(routes, claims, robot, travel, heading, sensing_radius);
    const bool back = goes_back(routes, robot, travel);
    go_around_held(routes, robot, left, in_company || back ? time_step : 0.0, travel, scratch);
    if (back) go_back(robot.place, in_company, heading);
    result.by_route.yields = heading.yields;
  }
  if (routes.goes_around_movers())
    heading = beside_resting(routes.resting(), heading, robot.place, robot.end,
                             robot.traits.route_radius);
  return result;
}

}  // namespace avo::inline guidance
