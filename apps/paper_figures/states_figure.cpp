// SPDX-License-Identifier: Apache-2.0
// Not in the paper: the places at which a robot of one velocity is safe, doomed or neither
// (docs/states.md).
#include "figures/state_map.h"
#include "figures_of_the_paper.h"
#include "panels.h"

namespace avo::paper {
namespace {

// Returns a robot that drives at 2 m/s to the right; it would stop within 2 m.
Simulation::Perception driving() {
  Simulation::Perception seen;
  seen.robot.position = {-3.6, -2.6};
  seen.robot.velocity = {2.0, 0.0};
  return seen;
}

Simulation::Perception meeting(Behavior behavior) {
  Simulation::Perception seen = driving();
  seen.neighbors = {{.position = {0.6, 0.0}, .velocity = {-1.0, 0.5}, .behavior = behavior}};
  seen.source = {1};
  return seen;
}

}  // namespace

std::string draw_states(const std::string& folder) {
  constexpr figures::Box kView{{-4.5, -3.5}, {2.5, 3.5}};
  constexpr int kCells = 280;
  const Planner planner({});
  Simulation::Perception beside_wall = driving();
  beside_wall.walls = {{.a = {0.0, -1.2}, .b = {1.2, 1.2}}};
  struct Panel {
    const char* title;
    Simulation::Perception seen;
  };
  const Panel panels[] = {{"(a) a wall", beside_wall},
                          {"(b) one that decides", meeting(Behavior::decides)},
                          {"(c) one that moves on", meeting(Behavior::moves_on)}};
  const Row row{.panels = 3};
  std::string path = folder + "/states.png";
  figures::Canvas canvas(path, row.width, row.height());
  for (int k = 0; k < 3; ++k) {
    write_title(canvas, row.box(k), panels[k].title);
    draw_state_map(canvas, row.box(k), panels[k].seen, planner, kView, kCells);
  }
  save(path, canvas.finish());
  return path;
}

}  // namespace avo::paper
