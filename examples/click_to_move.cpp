// SPDX-License-Identifier: Apache-2.0
// Units of a game go where the player clicks, and form up there. No two of their ways cross.
#include <cstdio>
#include <vector>

#include <avo/avo.h>

int main() {
  avo::Scenario scene;
  for (int k = 0; k < 40; ++k) {
    const avo::Vec2 place{1.6 * (k % 8), 1.6 * (k / 8)};
    scene.robots.push_back({.position = place, .goal = place});
  }
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  std::vector<avo::RobotId> selected;
  for (std::size_t k = 0; k < 40; ++k) selected.push_back({k});

  bool all_there = true;
  struct Click {
    avo::Vec2 place;  // m
    double heading;   // rad
    avo::Formation formation;
  };
  for (const Click& click :
       {Click{{40, 10}, 0.0, avo::Formation::wedge}, Click{{40, -30}, -1.57, avo::Formation::line},
        Click{{0, -30}, 3.14, avo::Formation::block}}) {
    const std::vector<avo::Vec2> slots = avo::formation_slots(click.formation, 40, 1.8);
    avo::form_up(simulation, selected, avo::place_slots(slots, click.place, click.heading));
    const double begin = simulation.time();
    while (!simulation.all_at_goal() && simulation.can_step_by(begin + 120.0))
      simulation.step(), metrics.observe(simulation);
    all_there = all_there && simulation.all_at_goal();
    std::printf("a %s after %.1f s\n", to_string(click.formation), simulation.time() - begin);
  }
  const avo::RunSummary summary = metrics.summary();
  std::printf("%d pairs touched\n", int(summary.collision_pairs));
  return all_there && summary.collision_pairs == 0 ? 0 : 1;
}
