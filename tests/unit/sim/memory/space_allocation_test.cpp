// SPDX-License-Identifier: Apache-2.0
// Nothing is allocated per step of a fleet in space once it is warm.
#include <gtest/gtest.h>

#include "avo/space/events.h"
#include "avo/space/simulation.h"
#include "unit/sim/counting_new.h"
#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

using test::allocations;

// Robots in a ball, with goals within a smaller one.
Scenario gathering(int count, double goals_within) {
  Scenario scene;
  Draws draws(3);
  for (int k = 0; k < count; ++k) {
    RobotSetup& robot = scene.robots.emplace_back();
    robot.position = {1.5 * (k % 7), 1.5 * (k / 7 % 7), 1.5 * (k / 49)};
    robot.goal = Vec3{4.5, 4.5, 4.5} + draws.within(goals_within);
  }
  return scene;
}

TEST(AllocationInSpace, none_per_step_where_goals_are_shared) {
  for (const double within : {0.0, 2.0}) {
    Simulation simulation(gathering(40, within), 1);
    for (int k = 0; k < 150; ++k) simulation.step();
    const long before = allocations;
    for (int k = 0; k < 100; ++k) simulation.step();
    EXPECT_EQ(allocations - before, 0) << within;
  }
}

TEST(AllocationInSpace, none_per_look_for_events_where_nothing_happens) {
  Scenario scene = gathering(60, 6.0);
  scene.certificate = Certificate::none;
  for (int k = 0; k < 5; ++k)
    scene.moving_obstacles.push_back(
        {.position = {-8.0 - 4.0 * k, 4.0, 1.0 * k}, .velocity = {1.5, 0.0, 0.0}});
  Simulation simulation(scene, 1);
  Events events(simulation, {.stuck_after = 1.0});
  int without = 0, with = 0;  // steps
  for (int k = 0; k < 200; ++k) {
    simulation.step();
    const long before = allocations;
    const bool is_empty = events.observe(simulation).empty();
    (is_empty ? without : with) += 1;
    if (!is_empty || k <= 60) continue;
    EXPECT_EQ(allocations, before) << k;
  }
  EXPECT_GT(without, 60);
  EXPECT_GT(with, 10);
}

}  // namespace
}  // namespace avo::space::tests
