// SPDX-License-Identifier: Apache-2.0
// Scenes that a host changes between two steps.
#pragma once
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo::test {

inline void run_for(Simulation& simulation, double seconds) {
  const double until = simulation.time() + seconds - 1e-9;
  while (simulation.time() < until) simulation.step();
}

inline Scenario two_lanes() {
  Scenario scene;
  scene.robots = {robot_at({-20, 0}, {40, 0}), robot_at({20, 3}, {-40, 3})};
  return scene;
}

// A small office with robots of several sizes and a mover.
inline Simulation furnished() {
  Scenario scene;
  scene.obstacles = {{{{{{-15, -15}, {15, -15}, {15, 15}, {-15, 15}}, true}}, 0.0, Fill::bounds},
                     {{{{{2, 2}, {5, 2}, {5, 6}, {2, 6}}, true}}, 0.1, Fill::solid},
                     {{{{{-8, -3}}, false}}, 1.0, Fill::none}};
  scene.moving_obstacles = {{.position = {-5, 8}, .velocity = {0.5, 0}, .radius = 0.7}};
  for (int k = 0; k < 20; ++k) {
    RobotSetup robot = robot_at({-12.0 + 1.3 * k, -10.0 + 0.3 * (k % 4)}, {12.0 - 1.2 * k, 11.0});
    robot.radius = 0.25 + 0.02 * (k % 7);
    scene.robots.push_back(robot);
  }
  return Simulation(scene, 1);
}

}  // namespace avo::test
