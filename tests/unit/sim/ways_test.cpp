// SPDX-License-Identifier: Apache-2.0
// Robots follow their ways around walls.
#include "sim/ways.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "avo/simulation.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

Scenario scene_among(const std::vector<Wall>& walls) {
  Scenario scene;
  scene.obstacles = {test::pieces(walls)};
  return scene;
}

TEST(Ways, ALoneRobotGetsThroughAMazeInTime) {
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const std::vector<Wall> walls = test::maze(10, 3.0, seed);
    Scenario scene = scene_among(walls);
    RobotSetup robot = test::robot_at(test::cell_of_maze(0), test::cell_of_maze(99));
    robot.preferred_speed = 1.5;
    scene.robots = {robot};
    const CornerGraph graph = corner_graph(walls, robot.radius);
    LegScratch scratch;
    const double path = next_leg(graph, path_map(graph, robot.goal), robot.position,
                                 PathMap::kNothing, false, scratch)
                            .length;
    const double v = robot.preferred_speed, a = robot.max_acceleration;
    const double limit = 1.35 * (path / v + v / a);
    Simulation simulation(scene, 1);
    while (!simulation.all_at_goal() && simulation.time() < limit) simulation.step();
    EXPECT_TRUE(simulation.all_at_goal()) << seed;
    worst = std::max(worst, simulation.time() / (path / v + v / a));
    for (int k = 0; k < 50; ++k) simulation.step();
    EXPECT_LT(norm(simulation.fleet().position[0] - robot.goal), 1e-3);
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST(Ways, WithoutNavigationItHeadsStraightForItsGoal) {
  Scenario scene = scene_among(test::two_rooms(2.0));
  scene.robots = {test::robot_at({3, 8}, {17, 8})};
  EXPECT_LT(Simulation(scene, 1).perceive(0).robot.preferred_velocity.y, -0.1);
  scene.navigation = false;
  EXPECT_EQ(Simulation(scene, 1).perceive(0).robot.preferred_velocity.y, 0.0);
}

TEST(Ways, DistanceToTheGoalIsThatOfTheWay) {
  Scenario scene = scene_among(test::two_rooms(2.0));
  scene.robots = {test::robot_at({9, 9}, {11, 9})};
  const Robot robot = Simulation(scene, 1).perceive(0).robot;
  EXPECT_GT(robot.distance_to_goal, 6.0);
  EXPECT_LT(robot.distance_to_goal, 9.0);
}

TEST(Ways, AWallBetweenMeansNotArrived) {
  Scenario scene = scene_among({{{0, -5}, {0, 5}, 0}});
  RobotSetup robot = test::robot_at({-0.1, 0}, {0.1, 0});
  robot.radius = 0.05;
  scene.robots = {robot};
  Simulation simulation(scene, 1);
  EXPECT_FALSE(simulation.all_at_goal());
  while (!simulation.all_at_goal() && simulation.time() < 60.0) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_GT(simulation.fleet().position[0].x, -0.01);
  EXPECT_GT(simulation.time(), 5.0);
}

TEST(Ways, TellsWhoCannotReachItsGoal) {
  Scenario scene = scene_among(test::two_rooms(1.2));
  scene.robots = {test::robot_at({3, 3}, {17, 3}), test::robot_at({3, 6}, {17, 6}),
                  test::robot_at({5, 8}, {9.8, 8}), test::robot_at({7, 2}, {-5, 2})};
  scene.robots[1].radius = 0.7;
  Simulation simulation(scene, 1);
  const std::vector<RobotId> lost{{1}, {2}, {3}};
  EXPECT_EQ(simulation.unreachable(), lost);
  for (int k = 0; k < 30; ++k) simulation.step();
  EXPECT_EQ(simulation.fleet().position[2], scene.robots[2].position);
  EXPECT_FALSE(simulation.fleet().position[0] == scene.robots[0].position);

  simulation.set_goal({2}, {9.0, 8.0});
  simulation.set_goal({0}, {-5.0, 0.0});
  simulation.add_robot(test::robot_at({18, 9}, {30, 9}));
  simulation.remove_robot({1});
  const std::vector<RobotId> then{{0}, {3}, {4}};
  EXPECT_EQ(simulation.unreachable(), then);
  scene.navigation = false;
  EXPECT_EQ(Simulation(scene, 1).unreachable(), lost);
}

TEST(Ways, AreTheSameForAnyNumberOfThreads) {
  const Scenario scene = test::crowded_maze(300);
  Simulation one(scene, 1), three(scene, 3);
  for (int k = 0; k < 60; ++k) one.step(), three.step();
  EXPECT_EQ(one.state_hash(), three.state_hash());
}

TEST(Ways, PerceiveIsWhatTheStepDecidesOn) {
  const Scenario scene = test::crowded_maze(40);
  Simulation simulation(scene, 1);
  for (int k = 0; k < 25; ++k) simulation.step();
  std::vector<Plan> plans;
  PlanWorkspace workspace;
  for (std::size_t k = 0; k < 40; ++k) {
    Simulation::Perception seen = simulation.perceive(k);
    plans.push_back(
        simulation.planner().plan(seen.robot, seen.neighbors, workspace, &seen.detour, seen.walls));
  }
  simulation.step();
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_EQ(simulation.fleet().plan[k].new_velocity, plans[k].new_velocity);
  }
}

TEST(Ways, GoOnAfterARestore) {
  const Scenario scene = test::crowded_maze(80);
  Simulation simulation(scene, 1);
  for (int k = 0; k < 47; ++k) simulation.step();
  const std::vector<std::byte> saved = simulation.save();
  for (int k = 0; k < 60; ++k) simulation.step();
  const std::uint64_t later = simulation.state_hash();
  simulation.restore(saved);
  for (int k = 0; k < 60; ++k) simulation.step();
  EXPECT_EQ(simulation.state_hash(), later);
}

}  // namespace
}  // namespace avo
