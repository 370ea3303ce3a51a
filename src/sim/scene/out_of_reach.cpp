// SPDX-License-Identifier: Apache-2.0
// Finds the robots that cannot reach their goals, for a scene before its simulation.
#include "avo/reachability.h"
#include "guidance/routes.h"
#include "robots/model.h"
#include "sim/columns/static_world.h"

namespace avo {

std::vector<OutOfReach> out_of_reach(const Scenario& scenario) {
  const StaticWorld statics = static_world(scenario);
  std::vector<OutOfReach> result;
  std::vector<Routes> all;
  // the ends of routes do not depend on how the routes lead there
  for (const Floor& floor : statics.floors)
    all.emplace_back(RouteRules{.routes = false}, floor.walls, std::vector<Wall>());
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) {
    const RobotSetup& robot = scenario.robots[k];
    if (is_parked(robot)) continue;
    Routes& routes = all[statics.floor_of(robot.layers).value_or(0)];
    if (routes.empty()) continue;
    const double radius = route_radius(robot.model, disc_radius(robot));
    const Travel travel =
        routes.plan(radius, disc_center(robot), robot.goal, arrival_distance_of(scenario, robot));
    if (travel.ends == RouteEnd::goal) continue;
    result.push_back({{k},
                      travel.place,
                      norm(robot.goal - travel.place),
                      !routes.is_free(radius, robot.goal),
                      travel.ends == RouteEnd::beside});
  }
  return result;
}

}  // namespace avo
