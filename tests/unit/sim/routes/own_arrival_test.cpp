// SPDX-License-Identifier: Apache-2.0
// Robots with an arrival distance of their own arrive by it, and whatever judges arrivals knows it.
#include <gtest/gtest.h>
#include <optional>

#include "avo/check.h"
#include "avo/checked.h"
#include "avo/metrics.h"
#include "avo/reachability.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::refusal;
using test::robot_at;

RobotSetup with_distance(Vec2 position, Vec2 goal, std::optional<double> distance) {
  RobotSetup robot = robot_at(position, goal);
  robot.arrival_distance = distance;
  return robot;
}

// The lanes are 20 m apart: no robot hinders another one.
Scenario lanes() {
  Scenario scene;
  scene.sensing_radius = 10.0;
  scene.robots = {with_distance({0, 0}, {20, 0}, std::nullopt),
                  with_distance({0, 20}, {20, 20}, 3.0), with_distance({0, 40}, {20, 40}, 0.05)};
  return scene;
}

TEST(OwnArrival, is_judged_for_each_robot_by_its_own_distance) {
  const Scenario scene = lanes();
  Simulation simulation(scene, 1);
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& robot : scene.robots) robots.push_back(checked_robot(robot));
  Check check(robots, {}, {.arrival_distance = scene.arrival_distance});
  Metrics metrics(scene);
  check.add(0.0, checked_states(simulation.fleet()));
  metrics.observe(simulation);
  std::vector<double> first(3, -1.0), distance(3, -1.0);
  while (simulation.time() < 40.0) {
    simulation.step();
    check.add(simulation.time(), checked_states(simulation.fleet()));
    metrics.observe(simulation);
    for (std::size_t k = 0; k < 3; ++k) {
      if (first[k] >= 0.0 || !simulation.is_at_goal({k})) continue;
      first[k] = simulation.time();
      distance[k] = norm(simulation.fleet().position[k] - scene.robots[k].goal);
    }
  }
  EXPECT_LT(first[1] + 0.5, first[0]);
  EXPECT_LT(first[0] + 0.5, first[2]);
  EXPECT_TRUE(distance[1] <= 3.0 && distance[1] > 2.0) << distance[1];
  EXPECT_TRUE(distance[0] <= 0.5 && distance[0] > 0.2) << distance[0];
  EXPECT_LE(distance[2], 0.05);
  EXPECT_EQ(check.report().arrived, 3);
  EXPECT_EQ(check.report().last_arrival, first[2]);
  EXPECT_EQ(metrics.summary().arrived, 3U);
  EXPECT_EQ(metrics.summary().last_arrival, first[2]);
}

TEST(OwnArrival, comes_back_from_the_simulation_and_from_saved_bytes) {
  Scenario scene = lanes();
  scene.robots[1].arrival_distance = scene.arrival_distance;  // as the scene's, and still its own
  Simulation simulation(scene, 1);
  for (int k = 0; k < 10; ++k) simulation.step();
  Simulation again(simulation.save(), 1);
  for (const Simulation* one : {&simulation, &again})
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(one->fleet().setup[k].arrival_distance, scene.robots[k].arrival_distance) << k;
  while (simulation.time() < 40.0) simulation.step(), again.step();
  EXPECT_EQ(simulation.state_hash(), again.state_hash());
  EXPECT_TRUE(again.all_at_goal());
}

// A goal in a wall is arrived at from the nearest place, if that is near enough.
TEST(OwnArrival, decides_whether_a_goal_in_a_wall_is_reached) {
  Scenario scene;
  scene.sensing_radius = 10.0;
  scene.obstacles = {{{{{{5, -3}, {11, -3}, {11, 3}, {5, 3}}, true}}, 0.0, Fill::solid}};
  scene.robots = {with_distance({0, 0}, {6.5, 0}, 2.5), with_distance({0, 30}, {8, 30}, {})};
  EXPECT_EQ(out_of_reach(scene).size(), 1U);
  EXPECT_TRUE(out_of_reach(scene)[0].counts_as_there);
  Simulation simulation(scene, 1);
  EXPECT_EQ(simulation.unreachable().size(), 0U);
  while (simulation.time() < 30.0) simulation.step();
  EXPECT_TRUE(simulation.is_at_goal({0}));
  scene.robots[0].arrival_distance = 1.5;
  Simulation strict(scene, 1);
  EXPECT_EQ(strict.unreachable().size(), 1U);
  while (strict.time() < 30.0) strict.step();
  EXPECT_FALSE(strict.is_at_goal({0}));
}

TEST(OwnArrival, of_an_airplane_counts_where_it_passes) {
  Scenario scene;
  scene.sensing_radius = 60.0;
  RobotSetup plane = with_distance({0, 0}, {50, 1.5}, 5.0);
  plane.model = Airplane{};
  plane.velocity = {2, 0};
  scene.robots = {plane};
  Simulation near(scene, 1);
  while (near.time() < 60.0 && !near.is_at_goal({0})) near.step();
  EXPECT_TRUE(near.is_at_goal({0}));
  EXPECT_GT(norm(near.fleet().position[0] - plane.goal), 3.0);
}

TEST(OwnArrival, is_refused_where_it_says_nothing) {
  Scenario scene = lanes();
  scene.robots[1].arrival_distance = 0.0;
  EXPECT_EQ(refusal(scene), "robots.1.arrival_distance: found 0, must be > 0 m");
  scene.robots[1] = with_distance({9, 9}, {9, 9}, 1.0), scene.robots[1].behavior = Behavior::parked;
  EXPECT_EQ(refusal(scene), "robots.1.arrival_distance: found 1, must be left out: it is parked");
}

}  // namespace
}  // namespace avo
