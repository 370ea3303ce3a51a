// SPDX-License-Identifier: Apache-2.0
// Runs of robots that have one goal, or goals with no room for all.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <span>

#include "avo/metrics.h"
#include "avo/simulation.h"

namespace avo::test {

struct Rally {
  std::int64_t at_rest = 0;  // robots that rest at their places in the end
  std::int64_t arrived = 0, contacts = 0;
  double rest = 0.0, bound = 0.0;  // s
};

inline double bound_of(const Scenario& scene, const Simulation& simulation) {
  double ways = 0.0, slowest = 0.0;
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    const RobotSetup& robot = scene.robots[k];
    const double v = robot.preferred_speed, a = robot.max_acceleration;
    ways = std::max(ways, simulation.route({k}).length / v + v / a);
    slowest = std::max(slowest, robot.max_speed / a);
  }
  return ways + 4.0 * slowest * std::sqrt(static_cast<double>(scene.robots.size()));
}

inline Rally run_rally(const Scenario& scene, double seconds) {
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  Rally result;
  result.bound = bound_of(scene, simulation);
  metrics.observe(simulation);
  while (simulation.can_step_by(seconds)) {
    simulation.step();
    metrics.observe(simulation);
    const std::span<const Vec2> velocity = simulation.fleet(Columns::velocity).velocity;
    if (std::any_of(velocity.begin(), velocity.end(), [](Vec2 v) { return v != Vec2{}; }))
      result.rest = simulation.time();
  }
  const std::span<const Vec2> velocity = simulation.fleet(Columns::velocity).velocity;
  for (std::size_t k = 0; k < velocity.size(); ++k)
    result.at_rest += velocity[k] == Vec2{} && simulation.is_at_goal({k}) ? 1 : 0;
  const RunSummary summary = metrics.summary();
  result.arrived = summary.arrived;
  result.contacts = summary.collision_pairs + summary.static_collisions;
  return result;
}

/// late: s, that it may take longer.
inline void expect_rest(const Scenario& scene, double late = 0.0) {
  const Rally rally = run_rally(scene, 100.0);
  EXPECT_EQ(rally.at_rest, static_cast<std::int64_t>(scene.robots.size()));
  EXPECT_LE(rally.rest, rally.bound + late);
  EXPECT_EQ(rally.contacts, 0);
}

}  // namespace avo::test
