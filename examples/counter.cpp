// SPDX-License-Identifier: Apache-2.0
// Robots queue at a charger. The host serves the first one whenever the charger is free.
#include <cstdio>
#include <vector>

#include <avo/avo.h>

int main() {
  avo::Scenario scene;
  std::vector<avo::RobotId> all;
  for (int k = 0; k < 8; ++k) {
    avo::RobotSetup robot;
    robot.radius = 0.3;
    robot.position = {-6.0 - 1.5 * (k % 4), 3.0 * (k / 4)};
    robot.goal = {10.0, 1.5 * k};
    all.push_back({scene.robots.size()});
    scene.robots.push_back(robot);
  }
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  avo::Team queue =
      avo::make_team(all, avo::Queue{.line = {{4, 0}, {0, 0}, {0, -10}}, .spacing = 1.0});
  const avo::Vec2 charger{4, 0};  // m
  double charged = 0.0;           // s
  int served = 0;
  while (simulation.can_step_by(120.0)) {
    lead(simulation, queue);
    simulation.step();
    metrics.observe(simulation);
    if (queue.members.empty()) continue;
    const avo::RobotId first = queue.members.front().robot;
    const bool is_there = norm(simulation.robot(first).position - charger) < 0.5;
    charged = is_there ? charged + 0.1 : 0.0;
    if (charged < 3.0) continue;
    serve(simulation, queue);
    ++served;
  }
  const avo::RunSummary summary = metrics.summary();
  const bool all_there = simulation.all_at_goal();
  std::printf("%d of 8 were charged, %s, %d pairs touched\n", served,
              all_there ? "all are at their goals" : "some are not at their goals",
              int(summary.collision_pairs));
  return served == 8 && all_there && summary.collision_pairs == 0 ? 0 : 1;
}
