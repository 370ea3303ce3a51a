// SPDX-License-Identifier: Apache-2.0
#include "avo/space/reachability.h"
#include "space/routes/routes.h"

namespace avo::space {

std::vector<OutOfReach> out_of_reach(const Scenario& scenario) {
  std::vector<OutOfReach> found;
  if (!scenario.navigation || scenario.boxes.empty()) return found;
  std::vector<Robot> robots;
  std::vector<Vec3> goals;
  for (const RobotSetup& setup : scenario.robots) {
    robots.push_back(robot_of(setup));
    goals.push_back(setup.goal);
  }
  SpaceRoutes routes(scenario.boxes, robots, goals, true);
  HeadingScratch scratch;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    routes.look(k, robots[k], goals[k], scratch);
    const SpaceRoute* route = routes.route(k);
    if (route == nullptr || route->reaches || route->points.empty()) continue;
    found.push_back({{k}, route->points.back().place, route->left, route->is_in_box});
  }
  return found;
}

}  // namespace avo::space
