// SPDX-License-Identifier: Apache-2.0
// A navigator decides as a simulation does, and robots with a navigator each pass a door in turn.
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "avo/simulation.h"
#include "unit/navigation/buildings.h"
#include "unit/navigator/on_board.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::OnBoard;

// Follows each robot of a simulation by a navigator that sees what the robot perceives.
void expect_as_simulated(const Scenario& scene, int steps) {
  Simulation simulation(scene, 1);
  OnBoard fleet(scene);
  int differ = 0;
  for (int k = 0; k < steps; ++k) {
    std::vector<NavigatorDecision> decided;
    for (std::size_t i = 0; i < fleet.navigators.size(); ++i) {
      const Simulation::Perception seen = simulation.perceive({i});
      decided.push_back(fleet.navigators[i].step(seen.robot, seen.neighbors, simulation.time()));
      EXPECT_EQ(decided.back().preferred_velocity, seen.robot.preferred_velocity) << k << " " << i;
      EXPECT_EQ(decided.back().guide, seen.guide);
      EXPECT_EQ(decided.back().wait.has_value(), seen.wait.has_value());
    }
    simulation.step();
    for (std::size_t i = 0; i < decided.size(); ++i) {
      const Plan plan = simulation.robot({i}).plan;
      if (!(decided[i].plan.next_velocity == plan.next_velocity)) ++differ;
      EXPECT_EQ(decided[i].plan.status, plan.status);
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(differ, 0);
}

// 5 + 5 robots change rooms through a door.
Scenario through_door(double width) {
  Scenario scene;
  scene.duration = 120.0;
  scene.obstacles = {test::pieces(test::doorway(width))};
  for (int k = 0; k < 5; ++k) {
    const double y = 2.0 * k - 4.0;
    scene.robots.push_back(test::robot_at({-8.0 - 0.3 * k, y}, {8.0, -y}));
    scene.robots.push_back(test::robot_at({8.0 + 0.2 * k, y + 0.1}, {-8.0, -y}));
  }
  return scene;
}

TEST(NavigatorFleet, decides_as_a_simulation_does_at_a_door) {
  expect_as_simulated(through_door(1.6), 300);
}

TEST(NavigatorFleet, decides_as_a_simulation_does_in_a_maze) {
  Scenario scene = test::crowded_maze(60);
  expect_as_simulated(scene, 60);
}

TEST(NavigatorFleet, decides_as_a_simulation_does_in_the_open) {
  Scenario scene;
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.5235987755982988 * k;
    const Vec2 place{8.0 * std::cos(angle), 8.0 * std::sin(angle)};
    scene.robots.push_back(test::robot_at(place, -place));
  }
  expect_as_simulated(scene, 150);
}

double last_arrival(const Scenario& scene) {
  Simulation simulation(scene, 1);
  while (!simulation.all_at_goal() && simulation.time() < 120.0) simulation.step();
  return simulation.time();
}

TEST(NavigatorFleet, passes_a_door_as_soon_as_a_simulation) {
  const Scenario scene = through_door(1.6);
  OnBoard fleet(scene);
  double nearest = 1.0;
  while (!fleet.all_reached() && fleet.time < 120.0) {
    fleet.step();
    for (std::size_t a = 0; a < fleet.bases.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        nearest =
            std::min(nearest, norm(fleet.bases[a].robot.position - fleet.bases[b].robot.position));
  }
  const double run = last_arrival(scene);
  RecordProperty("run", std::to_string(run));
  RecordProperty("on_board", std::to_string(fleet.time));
  EXPECT_LE(fleet.time, 1.1 * run);
  EXPECT_GE(nearest, 1.0 - 1e-9);
}

}  // namespace
}  // namespace avo
