// SPDX-License-Identifier: Apache-2.0
// Five robots follow a leader through a door, and keep their formation where there is room.
#include <algorithm>
#include <cstdio>
#include <vector>

#include <avo/avo.h>

int main() {
  avo::Scenario scene;
  scene.obstacles = {{{{{{20, -12}, {20, -0.9}}, false}, {{{20, 0.9}, {20, 12}}, false}}}};
  std::vector<avo::RobotId> robots;
  for (int k = 0; k < 6; ++k) {
    avo::RobotSetup robot;
    robot.radius = 0.3;
    robot.position = {-2.0 * k, 0.4 * (k % 2)};
    robot.goal = {45, 0};
    if (k == 0) robot.preferred_speed = 1.2;  // the others catch up
    robots.push_back({scene.robots.size()});
    scene.robots.push_back(robot);
  }
  std::vector<avo::Vec2> slots = avo::formation_slots(avo::Formation::wedge, 6, 1.5);
  const avo::Vec2 point = slots.front();  // the leader's own
  slots.erase(slots.begin());
  for (avo::Vec2& slot : slots) slot = slot - point;
  scene.teams = {avo::make_team(robots, avo::Follow{.spacing = 1.2, .slots = slots})};
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  double widest = 0.0, narrowest = 100.0;  // m, across the way, from 12 s on
  while (!simulation.all_at_goal() && simulation.can_step_by(90.0)) {
    simulation.step();
    metrics.observe(simulation);
    if (simulation.time() < 12.0) continue;
    double low = 100.0, high = -100.0;
    for (const avo::Vec2 place : simulation.fleet().position)
      low = std::min(low, place.y), high = std::max(high, place.y);
    widest = std::max(widest, high - low), narrowest = std::min(narrowest, high - low);
  }
  const avo::RunSummary summary = metrics.summary();
  std::printf("through after %.1f s, %.1f to %.1f m wide, %d pairs touched, %d walls\n",
              simulation.time(), narrowest, widest, int(summary.collision_pairs),
              int(summary.static_collisions));
  const bool is_safe = summary.collision_pairs == 0 && summary.static_collisions == 0;
  const bool has_formed = narrowest < 1.8 && widest > 3.0;  // in the door, and where there is room
  return simulation.all_at_goal() && has_formed && is_safe ? 0 : 1;
}
