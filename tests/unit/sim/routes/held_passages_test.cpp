// SPDX-License-Identifier: Apache-2.0
// Robots go around passages that others hold, and through them again.
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "avo/simulation.h"
#include "sim/travels.h"
#include "sim/world.h"
#include "unit/navigation/buildings.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

constexpr double kOneLane = 1.6, kTwoLanes = 2.4;  // m

// Two rooms, and between them so many ways of that width from x = -5 to x = 5, 6 m from each other;
// the first one is at y = 0, the others below it.
std::vector<Wall> lanes(int count, double width) {
  const double bottom = -6.0 * count - 2.0;
  std::vector<Wall> walls = test::ring({{-19, bottom}, {19, bottom}, {19, 8}, {-19, 8}});
  double top = 8.0;
  for (int k = 0; k <= count; ++k) {
    const double low = k < count ? 0.5 * width - 6.0 * k : bottom;
    const std::vector<Wall> block = test::ring({{-5, low}, {5, low}, {5, top}, {-5, top}});
    walls.insert(walls.end(), block.begin(), block.end());
    top = low - width;
  }
  return walls;
}

// This robot rests there and minds no other one: it makes no room.
RobotSetup holder(Vec2 place) {
  RobotSetup robot = test::robot_at(place, place);
  robot.avoids = {0};
  return robot;
}

Scenario held_scene(int count, const std::vector<int>& held, double width = kOneLane) {
  Scenario scene;
  scene.obstacles = {test::pieces(lanes(count, width))};
  scene.robots = {test::robot_at({-11, 0}, {11, 0})};
  for (const int lane : held) scene.robots.push_back(holder({0, -6.0 * lane}));
  return scene;
}

// When the first robot arrives; s.
double arrival_of(Simulation& simulation, double time) {
  while (!simulation.is_at_goal({0}) && simulation.time() < time) simulation.step();
  return simulation.time();
}

// Two lanes as far from a robot that does not want to move, and one at rest near it.
TEST(HeldPassages, make_nobody_wait_who_does_not_want_to_move) {
  Scenario scene;
  std::vector<Wall> walls = test::ring({{-19, -8}, {19, -8}, {19, 8}, {-19, 8}});
  for (const auto& [low, high] :
       {std::pair(-2.2, 2.2), std::pair(3.8, 8.0), std::pair(-8.0, -3.8)}) {
    const std::vector<Wall> block = test::ring({{-5, low}, {5, low}, {5, high}, {-5, high}});
    walls.insert(walls.end(), block.begin(), block.end());
  }
  scene.obstacles = {test::pieces(walls)};
  scene.robots = {test::robot_at({-11, 0}, {11, 0}), test::robot_at({-13, 3}, {-13, 3})};
  scene.robots[0].preferred_speed = 0.0;
  Simulation simulation(scene, 1);
  for (int k = 0; k < 200; ++k) {
    simulation.step();
    if (k % 10 != 9) continue;
    EXPECT_EQ(Simulation(simulation.save(), 1).state_hash(), simulation.state_hash());
  }
}

TEST(HeldPassages, are_gone_around_once_that_has_taken_as_long) {
  Scenario scene = held_scene(2, {0});
  Simulation free(held_scene(2, {}), 1), held(scene, 1), by_other(held_scene(2, {}), 1);
  const double straight = arrival_of(free, 60.0), around = arrival_of(held, 60.0);
  EXPECT_LT(straight, 20.0);
  EXPECT_GT(around, straight + 8.0) << "it waits first";
  EXPECT_LT(around, 45.0);
}

// A robot in the middle leaves no room past it, and no robot waits in turn. The robot that waits
// does so for longer.
TEST(HeldPassages, of_two_lanes_are_gone_around_later) {
  Simulation free(held_scene(2, {}, kTwoLanes), 1), held(held_scene(2, {0}, kTwoLanes), 1);
  const double straight = arrival_of(free, 60.0), around = arrival_of(held, 80.0);
  EXPECT_LT(straight, 20.0);
  EXPECT_GT(around, straight + 16.0) << "it waits first, for 8 T";
  EXPECT_LT(around, 55.0);
}

// There is no other route. After 32 T the robot goes back for as long as half of that, and comes
// again.
TEST(HeldPassages, of_two_lanes_without_another_way_send_those_back_who_have_waited) {
  Simulation simulation(held_scene(1, {0}, kTwoLanes), 1);
  const auto least_x = [&](double until) {
    double least = 100.0;
    while (simulation.time() < until) {
      simulation.step();
      least = std::min(least, simulation.robot({0}).position.x);
    }
    return least;
  };
  least_x(20.0);
  EXPECT_GT(least_x(60.0), -2.5) << "it waits";
  EXPECT_LT(least_x(80.0), -3.0) << "it goes back";
  test::expect_as_perceived(simulation);
  EXPECT_LT(least_x(100.0), -4.0);
  least_x(125.0);
  EXPECT_GT(simulation.robot({0}).position.x, -2.5) << "it has come again";
}

// The moving obstacle never rests, and so it is no wall of the route.
TEST(HeldPassages, are_gone_around_where_a_mover_walks_to_and_fro) {
  Scenario scene = held_scene(2, {});
  MovingObstacle mover;
  mover.position = {-1, 0}, mover.velocity = {0.2, 0}, mover.radius = 0.4;
  mover.max_deviation = 0.5, mover.max_speed = 0.3;
  mover.path = {{1, 0}, {-1, 0}};
  scene.moving_obstacles = {mover};
  Simulation simulation(scene, 1);
  EXPECT_LT(arrival_of(simulation, 120.0), 60.0);
  EXPECT_TRUE(simulation.is_at_goal({0}));
}

// It comes back out of the first lane and the second one, and finds the third.
TEST(HeldPassages, are_tried_one_after_the_other) {
  Simulation simulation(held_scene(3, {0, 1}), 1);
  EXPECT_LT(arrival_of(simulation, 120.0), 100.0);
}

// Both lanes are held at first, and it is at the second one when the first one becomes free.
TEST(HeldPassages, are_tried_again_where_no_other_way_is_left) {
  Simulation simulation(held_scene(2, {0, 1}), 1);
  while (simulation.time() < 60.0) simulation.step();
  simulation.set_goal({1}, {14, 5});
  EXPECT_LT(arrival_of(simulation, 180.0), 120.0);
}

TEST(HeldPassages, without_another_way_are_waited_at) {
  Simulation simulation(held_scene(1, {0}), 1);
  while (simulation.time() < 60.0) {
    simulation.step();
    EXPECT_LT(simulation.route({0}).length, 25.0);
  }
  simulation.set_goal({1}, {14, 5});
  EXPECT_LT(arrival_of(simulation, 100.0), 85.0);
}

// The robot does not turn back for the open passage: by then its shortest route leads elsewhere.
TEST(HeldPassages, are_open_again_to_whoever_has_gone_around) {
  World world(held_scene(2, {0}), std::make_unique<SerialExecutor>());
  world.travels = plan_travels(world.routes, world.fleet, world.floor, 0.5);
  const auto closed = [&] { return world.travels[0].waiting.closed.size(); };
  double opened_at = -100.0;  // m
  int openings = 0;
  for (int k = 0; k < 450; ++k) {
    const std::size_t before = closed();
    step(world);
    if (closed() >= before) continue;
    opened_at = world.fleet.position[0].x, ++openings;
  }
  EXPECT_EQ(openings, 1);
  EXPECT_GT(opened_at, 0.0);
  EXPECT_LT(norm(world.fleet.position[0] - Vec2{11, 0}), 0.1);
}

// Bit for bit, also while it goes around.
TEST(HeldPassages, are_saved) {
  const Scenario scene = held_scene(3, {0, 1});
  Simulation original(scene, 1);
  int differ = 0;
  while (!original.is_at_goal({0}) && original.time() < 100.0) {
    for (int k = 0; k < 40; ++k) original.step();
    const auto saved = original.save();
    Simulation restored(saved, 2);
    EXPECT_EQ(restored.save(), saved);
    Simulation ahead(saved, 1);
    for (int k = 0; k < 120; ++k) restored.step(), ahead.step();
    EXPECT_EQ(restored.state_hash(), ahead.state_hash());
    Simulation other(scene, 1);
    other.restore(saved);
    for (int k = 0; k < 120; ++k) other.step();
    differ += other.state_hash() == ahead.state_hash() ? 0 : 1;
  }
  EXPECT_EQ(differ, 0);
  EXPECT_TRUE(original.is_at_goal({0}));
}

// The run goes on as one that was never saved.
TEST(HeldPassages, stay_closed_over_a_restore_and_edits_elsewhere) {
  Simulation one(held_scene(2, {0}), 1), two(held_scene(2, {0}), 1);
  const StaticObstacle far{{Chain{{{-100, -100}, {-90, -100}}}}};
  while (!one.is_at_goal({0}) && one.time() < 60.0) {
    one.step(), two.step();
    if (two.steps() % 20 == 0) two.restore(two.save());
    if (two.steps() % 50 == 0) two.remove_obstacle(two.add_obstacle(far));
    ASSERT_EQ(one.state_hash(), two.state_hash()) << one.time();
  }
  EXPECT_TRUE(one.is_at_goal({0}));
}

}  // namespace
}  // namespace avo
