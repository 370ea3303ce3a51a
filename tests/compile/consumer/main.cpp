// SPDX-License-Identifier: Apache-2.0
// Uses the installed library as a user would; fails unless two robots pass each other.
#include <cstdio>

#include <avo/avo.h>

int main() {
  avo::Scenario scenario;
  scenario.name = "consumer";
  avo::RobotSetup robot;
  robot.position = {-10.0, 0.0};
  robot.goal = {10.0, 0.0};
  scenario.robots.push_back(robot);
  robot.position = {10.0, 0.5};
  robot.goal = {-10.0, 0.5};
  scenario.robots.push_back(robot);
  avo::Simulation simulation(scenario);
  avo::Metrics metrics(scenario);
  metrics.observe(simulation);
  while (!simulation.all_at_goal() && simulation.time() < 60.0) {
    simulation.step();
    metrics.observe(simulation);
  }
  const avo::RunSummary summary = metrics.summary();
  std::printf("avo %s: clearance %.3f m\n", avo::kVersion, summary.min_clearance.value_or(0.0));
  return simulation.all_at_goal() && summary.collision_pairs == 0 ? 0 : 1;
}
