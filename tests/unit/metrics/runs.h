// SPDX-License-Identifier: Apache-2.0
// Runs that are observed, and the true motion within their steps.
#pragma once
#include <utility>
#include <vector>

#include "avo/metrics.h"
#include "support/brute_force.h"
#include "unit/sim/scenes.h"

namespace avo {

inline RunSummary run(const Scenario& scene, int steps) {
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    metrics.observe(simulation);
  }
  return metrics.summary();
}

// Robots of method avo that stop at their goals.
inline Scenario alone(std::vector<RobotSetup> robots) {
  Scenario scene;
  scene.response_time = 0.0;  // trapezoids of speed, to be solved by hand
  scene.robots = std::move(robots);
  return scene;
}

// Robots that sense no other robot drive into each other.
inline Scenario blind(std::vector<RobotSetup> robots) {
  Scenario scene;
  scene.method = Method::avo_paper;
  scene.sensing_radius = 1e-3;
  scene.control_time = 2.0;
  scene.robots = std::move(robots);
  return scene;
}

inline RobotSetup cruising(Vec2 position, Vec2 goal) {
  RobotSetup setup = test::robot_at(position, goal);
  setup.velocity = 2.0 / norm(goal - position) * (goal - position);
  return setup;
}

/// Calls action(fleet, place) after each step, where place(i, t) is where robot i was at the time t
/// since the step began, by the equations of motion.
template <typename Action>
void for_each_step(const Scenario& scene, int steps, const Action& action) {
  const double delta = planner_options(scene).control_time;
  Simulation simulation(scene, 1);
  for (int k = 0; k < steps; ++k) {
    const FleetView before = simulation.fleet();
    const std::vector<Vec2> p(before.position.begin(), before.position.end());
    const std::vector<Vec2> v(before.velocity.begin(), before.velocity.end());
    simulation.step();
    const FleetView after = simulation.fleet();
    action(after, [&](std::size_t i, double t) {
      const Vec2 w = after.plan[i].new_velocity - v[i];
      double g = t;  // adopted at once
      if (!adopts_at_once(scene.method)) {
        g = scene.motion == Motion::held ? t * t / (2.0 * delta)
                                         : static_cast<double>(test::slow_gain(t, delta));
      }
      return p[i] + t * v[i] + g * w;
    });
  }
}

}  // namespace avo
