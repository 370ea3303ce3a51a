// SPDX-License-Identifier: Apache-2.0
// A robot that walls keep from its goal goes to the nearest place that it can reach, and rests
// there.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/metrics.h"
#include "avo/reachability.h"
#include "avo/simulation.h"
#include "unit/sim/judged.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::robot_at;

constexpr double kNear = 1e-4;  // m

RobotSetup small_robot(Vec2 position, Vec2 goal, double radius = 0.3) {
  RobotSetup robot = robot_at(position, goal);
  robot.radius = radius;
  return robot;
}

void run(Simulation& simulation, double until) {
  while (simulation.time() < until) simulation.step();
}

void expect_rests(const Simulation& simulation, std::size_t robot, Vec2 place) {
  const FleetView fleet = simulation.fleet();
  EXPECT_EQ(fleet.velocity[robot], (Vec2{0, 0})) << robot;
  EXPECT_LE(norm(fleet.position[robot] - place), kNear)
      << fleet.position[robot].x << ' ' << fleet.position[robot].y;
}

const std::vector<Wall> kDivided{{{-10, -5}, {10, -5}},
                                 {{10, -5}, {10, 5}},
                                 {{10, 5}, {-10, 5}},
                                 {{-10, 5}, {-10, -5}},
                                 {{0, -5}, {0, 5}}};

TEST(NearGoals, in_walls_are_arrived_at_from_as_near_as_can_be) {
  struct Case {
    StaticObstacle obstacle;
    Vec2 goal, place;
  };
  const auto box = [](Vec2 low, Vec2 high, Fill fill) {
    return StaticObstacle{{{{low, {high.x, low.y}, high, {low.x, high.y}}, true}}, 0.0, fill};
  };
  for (const Case& now :
       {Case{test::pieces({{{5, -5}, {5, 5}}}), {4.7001, 0}, {4.7, 0}},  // 0.1 mm too near
        Case{test::pieces({{{5, -5}, {5, 5}}}), {5, 0}, {4.7, 0}},       // on it
        Case{box({4.9, -0.1}, {5.1, 0.1}, Fill::solid), {4.95, 0}, {4.6, 0}},
        Case{box({4.9, -0.1}, {5.1, 0.1}, Fill::none), {5.0, 0.02}, {5.0, 0.4}},
        Case{StaticObstacle{{{{{5, 0}}}}, 0.15}, {5, 0}, {4.55, 0}}}) {
    Scenario scene;
    scene.obstacles = {now.obstacle};
    scene.robots = {small_robot({-5, 0}, now.goal)};
    Simulation simulation(scene, 1);
    EXPECT_TRUE(simulation.unreachable().empty());
    EXPECT_NEAR(simulation.route({0}).distance_left, norm(now.goal - now.place), kNear);
    run(simulation, 20.0);
    expect_rests(simulation, 0, now.place);
    EXPECT_TRUE(simulation.all_at_goal());
    const std::vector<OutOfReach> told = out_of_reach(scene);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_TRUE(told[0].is_in_wall && told[0].counts_as_there);
    EXPECT_NEAR(told[0].distance_left, norm(now.goal - now.place), kNear);
  }
}

// As with the default radius and arrival_distance, which are equal.
TEST(NearGoals, on_a_wall_are_arrived_at_from_exactly_the_arrival_distance) {
  Scenario scene;
  scene.obstacles = {test::pieces({{{5, -5}, {5, 5}}})};
  scene.robots = {small_robot({-5, 0}, {5, 0}, scene.arrival_distance)};
  Simulation simulation(scene, 1);
  run(simulation, 20.0);
  EXPECT_TRUE(simulation.unreachable().empty());
  EXPECT_TRUE(simulation.all_at_goal());
}

TEST(NearGoals, deep_in_an_obstacle_or_elsewhere_are_told_with_the_distance_left) {
  Scenario scene;
  scene.obstacles = {test::pieces(kDivided)};
  scene.robots = {small_robot({-8, 0}, {8, 0}),    // behind a closed door
                  small_robot({-8, 2}, {-20, 2}),  // outside of all walls
                  small_robot({3, 3}, {6, -2})};   // on a parked vehicle
  RobotSetup vehicle = small_robot({6, -2}, {6, -2}, 0.8);
  vehicle.behavior = Behavior::parked;
  scene.robots.push_back(vehicle);
  const Vec2 beside = Vec2{6, -2} + (1.1 / norm(Vec2{-3, 5})) * Vec2{-3, 5};
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  while (simulation.time() < 30.0) simulation.step(), metrics.observe(simulation);
  EXPECT_EQ(simulation.unreachable(), (std::vector<RobotId>{{0}, {1}, {2}}));
  expect_rests(simulation, 0, {-0.3, 0});
  expect_rests(simulation, 1, {-9.7, 2});
  expect_rests(simulation, 2, beside);
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.arrived, 1);
  EXPECT_EQ(summary.unreachable, (std::vector<std::uint64_t>{0, 1, 2}));
  ASSERT_EQ(summary.not_arrived.size(), 3u);
  for (const auto& [robot, distance] :
       {std::pair(0u, 8.3), std::pair(1u, 10.3), std::pair(2u, 1.1)}) {
    EXPECT_NEAR(summary.not_arrived[robot].distance, distance, kNear);
    EXPECT_NEAR(summary.not_arrived[robot].distance_left, distance, kNear);
    EXPECT_TRUE(std::isinf(simulation.route({robot}).length));
  }
  const std::vector<OutOfReach> told = out_of_reach(scene);
  ASSERT_EQ(told.size(), 3u);
  EXPECT_FALSE(told[0].is_in_wall || told[0].counts_as_there || told[1].is_in_wall);
  EXPECT_TRUE(told[2].is_in_wall && !told[2].counts_as_there);
}

// But where a route leads to the goal, the robot has not arrived before it has gone that route.
TEST(NearGoals, right_behind_a_wall_are_arrived_at_before_it_if_no_way_leads_around) {
  Scenario scene;
  scene.obstacles = {test::pieces(kDivided)};
  scene.robots = {small_robot({-8, 0}, {0.15, 0}, 0.1)};
  Simulation closed(scene, 1);
  run(closed, 20.0);
  expect_rests(closed, 0, {-0.1, 0});
  EXPECT_TRUE(closed.unreachable().empty() && closed.all_at_goal());
  scene.obstacles = {test::pieces({kDivided.begin(), kDivided.end() - 1}),
                     test::pieces({{{0, -4}, {0, 5}}})};
  scene.robots[0].position = {-0.101, 0};
  EXPECT_FALSE(Simulation(scene, 1).all_at_goal());
}

TEST(NearGoals, of_robots_without_any_way_leave_them_at_rest) {
  Scenario scene;
  scene.obstacles = {test::pieces({{{-0.4, -0.4}, {0.4, -0.4}},
                                   {{0.4, -0.4}, {0.4, 0.4}},
                                   {{0.4, 0.4}, {-0.4, 0.4}},
                                   {{-0.4, 0.4}, {-0.4, -0.4}}})};
  scene.robots = {small_robot({0, 0}, {8, 0})};
  Simulation simulation(scene, 1);
  run(simulation, 10.0);
  expect_rests(simulation, 0, {0.1, 0});
  EXPECT_EQ(simulation.unreachable(), std::vector<RobotId>{{0}});
  EXPECT_NEAR(simulation.route({0}).distance_left, 7.9, kNear);
}

TEST(NearGoals, are_gone_on_to_whenever_a_door_opens) {
  Scenario scene;
  scene.obstacles = {test::pieces({kDivided.begin(), kDivided.end() - 1}),
                     test::pieces({{{0, -5}, {0, -1}}, {{0, 1}, {0, 5}}})};
  scene.robots = {small_robot({-8, 0}, {8, 4}), small_robot({-8, 2}, {8, -4})};
  const StaticObstacle door = test::pieces({{{0, -1}, {0, 1}}});
  test::Judged judged(scene, 1);
  Simulation& simulation = judged.simulation;
  for (int times = 0; times < 3; ++times) {
    const ObstacleId closed = simulation.add_obstacle(door);
    EXPECT_EQ(simulation.unreachable().size(), 2u);
    judged.run(15.0);
    for (const std::size_t robot : {0u, 1u}) {
      EXPECT_EQ(simulation.fleet().velocity[robot], (Vec2{0, 0}));
      EXPECT_FALSE(simulation.is_at_goal({robot}));
    }
    simulation.remove_obstacle(closed);
    EXPECT_TRUE(simulation.unreachable().empty());
    judged.run(0.5);
    EXPECT_GT(norm(simulation.fleet().velocity[0]), 0.1);
  }
  judged.run(30.0);
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_TRUE(judged.report().safe());
}

// Doors elsewhere change nothing of where it goes, nor does the same goal once more.
TEST(NearGoals, stay_the_same_through_edits_and_equal_goals) {
  Scenario scene;
  scene.obstacles = {test::pieces({{{5, -5}, {5, 5}}})};
  RobotSetup vehicle = small_robot({0, 0}, {0, 0}, 0.8);
  vehicle.behavior = Behavior::parked;
  scene.robots = {small_robot({-8, 1}, {0, 0}), small_robot({-8, 3}, {5, 3.2}), vehicle};
  Simulation plain(scene, 1), edited(scene, 1);
  for (int k = 0; k < 150; ++k) {
    for (const std::uint64_t robot : {0u, 1u}) edited.set_goal({robot}, scene.robots[robot].goal);
    if (k % 10 == 0)
      edited.remove_obstacle(edited.add_obstacle(test::pieces({{{30, 30}, {31, 30}}})));
    plain.step(), edited.step();
    ASSERT_EQ(edited.fleet().position[0], plain.fleet().position[0]) << k;
    ASSERT_EQ(edited.fleet().position[1], plain.fleet().position[1]) << k;
  }
  expect_rests(plain, 1, {4.7, 3.2});
}

TEST(NearGoals, are_saved) {
  Scenario scene;
  scene.obstacles = {test::pieces(kDivided)};
  RobotSetup vehicle = small_robot({-4, -3}, {-4, -3}, 0.8);
  vehicle.behavior = Behavior::parked;
  scene.robots = {small_robot({-8, 0}, {8, 0}), small_robot({-8, 2}, {-4, -3}), vehicle,
                  small_robot({-8, -2}, {-2, -2})};
  Simulation simulation(scene, 1);
  run(simulation, 3.0);
  Simulation restored(simulation.save(), 1);
  EXPECT_EQ(restored.unreachable(), simulation.unreachable());
  EXPECT_EQ(restored.route({1}).distance_left, simulation.route({1}).distance_left);
  for (int k = 0; k < 200; ++k) {
    simulation.step(), restored.step();
    ASSERT_EQ(restored.state_hash(), simulation.state_hash()) << k;
  }
}

TEST(NearGoals, that_many_share_have_them_around) {
  Scenario scene;
  scene.obstacles = {test::pieces(kDivided)};
  for (int k = 0; k < 12; ++k)
    scene.robots.push_back(small_robot({-9.0 + k / 4, -3.0 + 2.0 * (k % 4)}, {8, 0}));
  test::Judged judged(scene, 1);
  judged.run(60.0);
  double nearest = 1e9;  // m
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    const double distance = norm(judged.simulation.fleet().position[k] - Vec2{-0.3, 0});
    EXPECT_LE(distance, 3.6) << k;
    EXPECT_EQ(judged.simulation.fleet().velocity[k], Vec2{}) << k << " has come to rest";
    nearest = std::min(nearest, distance);
  }
  EXPECT_LE(nearest, scene.arrival_distance);
  EXPECT_TRUE(judged.report().safe());
}

TEST(NearGoals, without_navigation_are_headed_for_straight) {
  Scenario scene;
  scene.navigation = false;
  scene.obstacles = {test::pieces(kDivided)};
  scene.robots = {small_robot({-8, 0}, {8, 4})};
  Simulation simulation(scene, 1);
  const Vec2 wish = simulation.perceive({0}).robot.preferred_velocity;
  EXPECT_NEAR(cross(wish, {16, 4}), 0.0, 1e-9);
  EXPECT_EQ(simulation.unreachable(), std::vector<RobotId>{{0}});
  EXPECT_TRUE(std::isinf(simulation.route({0}).length));
}

}  // namespace
}  // namespace avo
