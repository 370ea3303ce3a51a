// SPDX-License-Identifier: Apache-2.0
// Robots wait for a lift. Its door opens for a while, and closes once nobody stands in it.
#include <cstdio>

#include <avo/avo.h>

int main() {
  avo::Scenario scene;
  // a lift of 4 m by 4 m, whose door is 1.6 m wide
  scene.obstacles = {{{{{{0, 1.2}, {0, 4}, {4, 4}, {4, 0}, {0, 0}, {0, -0.4}}, false}}}};
  for (int k = 0; k < 4; ++k) {
    avo::RobotSetup robot;
    robot.radius = 0.3;
    robot.position = {-3.0 - k, 0.4};
    robot.goal = {1.0 + 1.2 * (k % 2), 1.0 + 1.2 * (k / 2)};
    scene.robots.push_back(robot);
  }
  const avo::StaticObstacle door{{{{{0, -0.4}, {0, 1.2}}, false}}};
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  avo::ObstacleId closed = simulation.add_obstacle(door);
  std::printf("door closed: %zu robots cannot reach their goals\n",
              simulation.unreachable().size());
  while (simulation.can_step_by(5.0)) simulation.step(), metrics.observe(simulation);
  simulation.remove_obstacle(closed);
  while (!simulation.all_at_goal() && simulation.can_step_by(60.0))
    simulation.step(), metrics.observe(simulation);
  std::printf("all inside %.1f s after it opened\n", simulation.time() - 5.0);
  while (!simulation.robots_within({0, 0.4}, 0.8).empty()) simulation.step();
  closed = simulation.add_obstacle(door);  // refused if a robot could not stop before it
  for (const avo::RobotId robot : {avo::RobotId{0}, avo::RobotId{1}})
    simulation.set_goal(robot, {-5, 0.4});
  std::printf("door closed: %zu robots want to get out, %d robots touched a wall\n",
              simulation.unreachable().size(), int(metrics.summary().static_collisions));
}
