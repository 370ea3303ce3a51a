// SPDX-License-Identifier: Apache-2.0
// Three hundred people leave a hall by two doors.
#include <cstdio>
#include <vector>

#include <avo/avo.h>

int main() {
  avo::Scenario scene;
  scene.obstacles = {{{{{{0, 8}, {0, 16}, {24, 16}, {24, 9}}, false},
                       {{{24, 7}, {24, 0}, {0, 0}, {0, 5}}, false}}}};
  std::vector<avo::RobotId> people;
  for (int k = 0; k < 300; ++k) {
    avo::RobotSetup person;
    person.radius = 0.25;
    person.max_speed = person.preferred_speed = 1.4;
    person.max_acceleration = 2.0;
    person.position = person.goal = {2.0 + 1.0 * (k % 20), 1.0 + 0.95 * (k / 20)};
    people.push_back({scene.robots.size()});
    scene.robots.push_back(person);
  }
  // doors of 2 m in the east and 3 m in the west: the goals are 1 m outside
  const avo::Flow flow{.exits = {{25, 7}, {25, 9}, {-1, 5}, {-1, 8}}, .spacing = 0.7};
  scene.teams = {avo::make_team(people, flow)};
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  while (simulation.size() > 0 && simulation.can_step_by(300.0)) {
    simulation.step();
    metrics.observe(simulation);
  }
  const avo::RunSummary summary = metrics.summary();
  std::printf("%zu of 300 are still inside after %.1f s, %d pairs touched, %d walls\n",
              simulation.size(), simulation.time(), int(summary.collision_pairs),
              int(summary.static_collisions));
  const bool is_safe = summary.collision_pairs == 0 && summary.static_collisions == 0;
  return simulation.size() == 0 && is_safe ? 0 : 1;
}
