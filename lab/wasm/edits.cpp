// SPDX-License-Identifier: Apache-2.0
// Changes by the host between steps. Each function throws Error on bad input.
#include <cstdint>
#include <string>

#include "avo_io/scene.h"
#include "host.h"

namespace avo_lab {

/// Adds the last robot of the scene in the room (its name, then its text), and returns the robot's
/// number.
AVO_EXPORT(double, add_robots_of)() {
  Input input(taken_from_room());
  const std::string name = input.text();
  const avo::Scenario scene = avo_io::parse_scenario(input.text(), name);
  avo::RobotId added;
  for (const avo::RobotSetup& robot : scene.robots) added = plane().simulation->add_robot(robot);
  return static_cast<double>(added.value);
}

/// Adds the obstacle of the scene in the room (its name, then its text), and returns the obstacle's
/// number.
AVO_EXPORT(double, add_obstacle_of)() {
  Input input(taken_from_room());
  const std::string name = input.text();
  const avo::Scenario scene = avo_io::parse_scenario(input.text(), name);
  avo::ObstacleId added;
  for (const avo::StaticObstacle& obstacle : scene.obstacles)
    added = plane().simulation->add_obstacle(obstacle);
  return static_cast<double>(added.value);
}

AVO_EXPORT(void, remove_robot)(std::uint32_t robot) {
  plane().simulation->remove_robot({robot});
}

AVO_EXPORT(void, remove_obstacle)(std::uint32_t obstacle) {
  plane().simulation->remove_obstacle({obstacle});
}

/// x, y: m.
AVO_EXPORT(void, set_goal)(std::uint32_t robot, double x, double y) {
  plane().simulation->set_goal({robot}, {x, y});
}

/// x, y: m.
AVO_EXPORT(void, move_robot)(std::uint32_t robot, double x, double y) {
  plane().simulation->move_robot({robot}, {x, y});
}

}  // namespace avo_lab
