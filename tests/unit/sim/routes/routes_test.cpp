// SPDX-License-Identifier: Apache-2.0
// Robots follow their routes around walls.
#include "guidance/routes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "avo/simulation.h"
#include "sim/columns/fleet.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

Scenario scene_among(const std::vector<Wall>& walls) {
  Scenario scene;
  scene.obstacles = {test::pieces(walls)};
  return scene;
}

TEST(Routes, ALoneRobotGetsThroughAMazeInTime) {
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const std::vector<Wall> walls = test::maze(10, 3.0, seed);
    Scenario scene = scene_among(walls);
    RobotSetup robot = test::robot_at(test::cell_of_maze(0), test::cell_of_maze(99));
    robot.preferred_speed = 1.5;
    scene.robots = {robot};
    const CornerGraph graph = corner_graph(walls, robot.radius);
    LegScratch scratch;
    const double path = next_leg(graph, path_map(graph, robot.goal), robot.position, robot.radius,
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

TEST(Routes, WithoutNavigationItHeadsStraightForItsGoal) {
  Scenario scene = scene_among(test::two_rooms(2.0));
  scene.robots = {test::robot_at({3, 8}, {17, 8})};
  EXPECT_LT(Simulation(scene, 1).perceive({0}).robot.preferred_velocity.y, -0.1);
  scene.navigation = false;
  EXPECT_EQ(Simulation(scene, 1).perceive({0}).robot.preferred_velocity.y, 0.0);
}

TEST(Routes, DistanceToTheGoalIsThatOfTheRoute) {
  Scenario scene = scene_among(test::two_rooms(2.0));
  scene.robots = {test::robot_at({9, 9}, {11, 9})};
  const Robot robot = Simulation(scene, 1).perceive({0}).robot;
  EXPECT_GT(robot.distance_to_goal, 6.0);
  EXPECT_LT(robot.distance_to_goal, 9.0);
}

TEST(Routes, AWallBetweenMeansNotArrived) {
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

// Nor does one in two pieces that touch right between.
TEST(Routes, AJointOfWallsBetweenMeansNotArrived) {
  for (const double x : {0.1, 0.3}) {
    Scenario scene = scene_among({{{0, -5}, {0, 0}, 0}, {{0, 0}, {0, 5}, 0}});
    RobotSetup robot = test::robot_at({-0.1, 0}, {x, 0});
    robot.radius = 0.05;
    scene.robots = {robot};
    EXPECT_FALSE(Simulation(scene, 1).all_at_goal());
  }
}

TEST(Routes, TellsWhoCannotReachItsGoal) {
  Scenario scene = scene_among(test::two_rooms(1.2));
  scene.robots = {test::robot_at({3, 3}, {17, 3}), test::robot_at({3, 6}, {17, 6}),
                  test::robot_at({5, 8}, {9.8, 8}), test::robot_at({7, 2}, {-5, 2})};
  scene.robots[1].radius = 0.7;
  Simulation simulation(scene, 1);
  const std::vector<RobotId> lost{{1}, {3}};
  EXPECT_EQ(simulation.unreachable(), lost);
  for (int k = 0; k < 30; ++k) simulation.step();
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

TEST(Routes, AreTheSameForAnyNumberOfThreads) {
  const Scenario scene = test::crowded_maze(300);
  Simulation one(scene, 1), three(scene, 3);
  for (int k = 0; k < 60; ++k) one.step(), three.step();
  EXPECT_EQ(one.state_hash(), three.state_hash());
}

TEST(Routes, PerceiveIsWhatTheStepDecidesOn) {
  const Scenario scene = test::crowded_maze(40);
  Simulation simulation(scene, 1);
  for (int k = 0; k < 25; ++k) simulation.step();
  std::vector<Plan> plans;
  PlanWorkspace workspace;
  for (std::size_t k = 0; k < 40; ++k) {
    Simulation::Perception seen = simulation.perceive({k});
    plans.push_back(
        simulation.planner().plan(seen.robot, seen.neighbors, workspace, &seen.detour, seen.walls));
  }
  simulation.step();
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_EQ(simulation.fleet().plan[k].new_velocity, plans[k].new_velocity);
  }
}

TEST(Routes, GoOnAfterARestore) {
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

TEST(Routes, OnMapsOfManyCornersLeadToAllGoals) {
  Scenario scene = test::noise_scene(12);
  scene.robots.push_back(test::robot_at({-4, 30}, {-4, -5}));
  Simulation simulation(scene, 2);
  EXPECT_TRUE(simulation.unreachable().empty());
  const CornerGraph graph = corner_graph(walls_of(scene.obstacles), 0.4);
  ASSERT_GT(graph.corners(), 10000u);
  while (!simulation.all_at_goal() && simulation.time() < 200.0) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
}

TEST(Routes, OnMapsOfManyCornersGoOnAfterARestore) {
  const Scenario scene = test::noise_scene(12);
  Simulation simulation(scene, 2);
  for (int k = 0; k < 47; ++k) simulation.step();
  const std::vector<std::byte> saved = simulation.save();
  for (int k = 0; k < 80; ++k) simulation.step();
  Simulation other(saved, 1);
  for (int k = 0; k < 80; ++k) other.step();
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
}

TEST(Routes, RadiiOfTwoDigitsAreClassesAndTheOthersGoUpToThem) {
  for (double scale : {1e-3, 1e-2, 0.1, 1.0}) {
    for (int digits = 10; digits < 100; ++digits) {
      const double radius = digits * 1000.0 / std::round(1000.0 / scale);
      EXPECT_EQ(radius_class(radius), radius);
    }
  }
  EXPECT_EQ(radius_class(0.3), 0.3);
  EXPECT_EQ(radius_class(std::nextafter(0.3, 1.0)), 0.31);
  EXPECT_EQ(radius_class(0.302), 0.31);
  EXPECT_EQ(radius_class(0.131), 0.135);
  EXPECT_EQ(radius_class(0.996), 1.0);
  test::Random random(3);
  std::set<double> classes;
  for (int k = 0; k < 10000; ++k) {
    const double radius = random.log_uniform(1e-6, 90.0);
    EXPECT_GE(radius_class(radius), radius);
    EXPECT_LE(radius_class(radius), 1.0501 * radius);
    EXPECT_EQ(radius_class(radius_class(radius)), radius_class(radius));
    classes.insert(radius_class(random.uniform(0.25, 0.5)));
  }
  EXPECT_EQ(classes.size(), 25u);
  for (const double odd : {1e-300, 123.4, 1e12}) EXPECT_GE(radius_class(odd), odd);
}

// A door wide enough for the robot, but not for its class.
TEST(Routes, ThoseWhomOnlyTheirVeryRadiusLetsThroughGetThrough) {
  const double radius = 0.5001;
  Scenario scene = scene_among(test::two_rooms(2.0 * radius + 2e-3));
  scene.robots = {test::robot_at({3, 7}, {17, 7}), test::robot_at({3, 8.1}, {0.5002, 8}),
                  test::robot_at({3, 2}, {7, 2})};
  for (RobotSetup& robot : scene.robots) robot.radius = radius;
  Routes routes(RouteRules{}, walls_of(scene.obstacles), {});
  EXPECT_EQ(routes.plan(radius, {3, 7}, {17, 7}, 0.5).graph->radius, radius);
  EXPECT_EQ(routes.plan(radius, {3, 8}, {0.5002, 8}, 0.5).graph->radius, radius);
  EXPECT_EQ(routes.plan(radius, {3, 2}, {7, 2}, 0.5).graph->radius, 0.51);
  EXPECT_EQ(routes.plan(0.504, {3, 2}, {7, 2}, 0.5).graph,
            routes.plan(radius, {3, 2}, {7, 2}, 0.5).graph);
  Simulation simulation(scene, 1);
  EXPECT_TRUE(simulation.unreachable().empty());
  for (int k = 0; k < 20; ++k) simulation.step();
  Simulation restored(simulation.save(), 1);
  while (!simulation.all_at_goal() && simulation.time() < 60.0) {
    simulation.step(), restored.step();
    ASSERT_EQ(restored.state_hash(), simulation.state_hash());
  }
  EXPECT_TRUE(simulation.all_at_goal());
}

// A robot that others push to where its class has no room.
TEST(Routes, FromBesideAWallThereIsARoute) {
  const Scenario scene = scene_among(test::two_rooms(2.0));
  Routes routes(RouteRules{}, walls_of(scene.obstacles), {});
  RobotSetup setup = test::robot_at({3, 9}, {11, 9});
  setup.radius = 0.5001;
  Travel travel = routes.plan(setup.radius, setup.position, setup.goal, 0.5);
  ASSERT_EQ(travel.graph->radius, 0.51);
  LegScratch scratch;
  const Vec2 place{9.4995, 9};
  for (const bool looks_around : {false, true}) {
    const Heading heading =
        follow(travel, place, setup.goal, traits_of(setup), 0.0, looks_around, scratch);
    EXPECT_LT(heading.goal.y, place.y - 5.0);
  }
}

}  // namespace
}  // namespace avo
