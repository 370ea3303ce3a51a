// SPDX-License-Identifier: Apache-2.0
// The simulation tells which robot waits at a passage, and for which one.
#include <cmath>
#include <gtest/gtest.h>
#include <optional>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "unit/navigation/buildings.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

// Two robots that want through a corridor of one lane, in opposite directions.
Scenario at_corridor() {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots = {test::robot_at({-7, 0}, {10, 3}), test::robot_at({12, 0}, {-10, 3})};
  return scene;
}

TEST(Waits, are_for_whoever_comes_through_the_passage) {
  Simulation simulation(at_corridor(), 1);
  int waits = 0;
  while (!simulation.all_at_goal() && simulation.time() < 60.0) {
    simulation.step();
    EXPECT_FALSE(simulation.wait({0}));
    const std::optional<Simulation::Wait> wait = simulation.wait({1});
    EXPECT_EQ(simulation.perceive({1}).wait.has_value(), wait.has_value());
    if (!wait) continue;
    ++waits;
    EXPECT_EQ(wait->robot.value, 0u);
    EXPECT_LE(norm(wait->passage), 1e-6);
    EXPECT_LT(simulation.fleet().position[0].x, 7.0);
  }
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_GT(waits, 20);
}

TEST(Waits, of_robots_at_rest_are_in_the_summary) {
  Scenario scene = at_corridor();
  scene.robots[0].preferred_speed = 0.7;  // so that the other one comes to rest meanwhile
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  const auto is_resting = [&] { return norm(simulation.fleet().velocity[1]) < 1e-3; };
  while (simulation.time() < 30.0 && !(simulation.wait({1}) && is_resting()))
    simulation.step(), metrics.observe(simulation);
  const RunSummary summary = metrics.summary();
  ASSERT_EQ(summary.not_arrived.size(), 2u);
  EXPECT_FALSE(summary.not_arrived[0].passage);
  ASSERT_TRUE(summary.not_arrived[1].passage);
  EXPECT_LE(norm(*summary.not_arrived[1].passage), 1e-6);
  EXPECT_EQ(summary.not_arrived[1].held_by, std::vector<std::int64_t>{0});
  EXPECT_EQ(summary.not_arrived[1].distance_left, 0.0);
}

TEST(Waits, are_none_without_passages_or_right_of_way) {
  Scenario scene = at_corridor();
  scene.right_of_way = RightOfWay::none;
  Simulation without(scene, 1);
  scene.obstacles.clear();
  Simulation open(scene, 1);
  for (int k = 0; k < 100; ++k) {
    without.step(), open.step();
    EXPECT_FALSE(without.wait({0}) || without.wait({1}) || open.wait({0}) || open.wait({1}));
  }
}

}  // namespace
}  // namespace avo
