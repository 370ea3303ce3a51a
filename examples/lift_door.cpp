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
  metrics.observe(simulation);
  const auto go_on = [&] { simulation.step(), metrics.observe(simulation); };
  avo::ObstacleId closed = simulation.add_obstacle(door);
  const std::size_t outside = simulation.unreachable().size();
  std::printf("door closed: %zu robots cannot reach their goals\n", outside);
  while (simulation.can_step_by(5.0)) go_on();
  simulation.remove_obstacle(closed);
  while (!simulation.all_at_goal() && simulation.can_step_by(60.0)) go_on();
  const bool all_inside = simulation.all_at_goal();
  std::printf("%s inside %.1f s after it opened\n", all_inside ? "all" : "not all",
              simulation.time() - 5.0);
  while (!simulation.robots_within({0, 0.4}, 0.8).empty() && simulation.can_step_by(90.0)) go_on();
  closed = simulation.add_obstacle(door);  // refused if a robot could not stop before it
  for (const avo::RobotId robot : {avo::RobotId{0}, avo::RobotId{1}})
    simulation.set_goal(robot, {-5, 0.4});
  const std::size_t inside = simulation.unreachable().size();
  const avo::RunSummary summary = metrics.summary();
  std::printf("door closed: %zu robots want to get out, %d robots touched a wall, %d pairs\n",
              inside, int(summary.static_collisions), int(summary.collision_pairs));
  const bool is_safe = summary.static_collisions == 0 && summary.collision_pairs == 0;
  return outside == 4 && all_inside && inside == 2 && is_safe ? 0 : 1;
}
