// SPDX-License-Identifier: Apache-2.0
// Routes around movers at rest (docs/navigation.md, "Movers at rest").
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

MovingObstacle disc(Vec2 position, double radius, Vec2 velocity = {}) {
  MovingObstacle result;
  result.position = position, result.radius = radius, result.velocity = velocity;
  return result;
}

// A row stands across the straight line to the goal, with gaps that no robot fits through.
Scenario row_of(int count, double y, Vec2 velocity = {}) {
  Scenario scene;
  scene.robots = {robot_at({-10, 0}, {10, 0})};
  for (int k = 0; k < count; ++k)
    scene.moving_obstacles.push_back(disc({0.0, y + k}, 0.6, velocity));
  return scene;
}

// s, until all have arrived; infinite if they do not within the time.
double arrival(Simulation& simulation, double within) {
  while (simulation.time() < within) {
    simulation.step();
    if (simulation.all_at_goal()) return simulation.time();
  }
  return std::numeric_limits<double>::infinity();
}

TEST(RestingMovers, in_a_row_are_gone_around) {
  for (const double y : {-3.0, -1.0, -5.5}) {
    Simulation simulation(row_of(7, y), 1);
    EXPECT_GT(simulation.route({0}).length, 20.0) << y;
    EXPECT_LE(arrival(simulation, 30.0), 16.0) << y;
  }
  // slow ones too, and as they go on
  Simulation slow(row_of(7, -3.0, {0.0, 0.04}), 1);
  EXPECT_LE(arrival(slow, 30.0), 16.0);
}

TEST(RestingMovers, are_gone_around_by_all_and_touched_by_nobody) {
  Scenario scene = row_of(9, -4.0);
  scene.moving_obstacles.erase(scene.moving_obstacles.begin() + 6);  // a gap
  scene.moving_obstacles.erase(scene.moving_obstacles.begin() + 6);
  scene.robots.clear();
  for (int k = 0; k < 6; ++k) {
    scene.robots.push_back(robot_at({-10.0, 1.5 * k - 4.0}, {10.0, 4.0 - 1.5 * k}));
    scene.robots.back().radius = 0.4;
  }
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int step = 0; step < 500; ++step) simulation.step(), metrics.observe(simulation);
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.arrived, 6);
  EXPECT_EQ(summary.mover_collisions, 0);
  EXPECT_EQ(summary.collision_pairs, 0);
}

TEST(RestingMovers, that_stand_on_a_goal_have_the_robot_beside_them) {
  for (const Vec2 off : {Vec2{0, 0}, Vec2{0.3, 0.4}}) {
    Scenario scene;
    scene.robots = {robot_at({-10, 0}, {0, 0})};
    scene.moving_obstacles = {disc(off, 0.6)};
    Simulation simulation(scene, 1);
    for (int step = 0; step < 250; ++step) simulation.step();
    const FleetView fleet = simulation.fleet();
    EXPECT_EQ(fleet.velocity[0], (Vec2{0, 0}));
    EXPECT_LE(norm(fleet.position[0] - off), 1.3);
    EXPECT_TRUE(simulation.unreachable().empty());
  }
}

// A cart blocks one of two doors, as long as it stands there.
TEST(RestingMovers, in_a_door_send_robots_through_another_one) {
  Scenario scene;
  scene.robots = {robot_at({-6, 0}, {6, 0})};
  for (const auto& [from, to] : {std::pair(-12.0, -1.0), std::pair(1.0, 5.0), std::pair(7.0, 12.0)})
    scene.obstacles.push_back({.chains = {{{{0, from}, {0, to}}}}});
  const Chain around{{{-20, -12}, {20, -12}, {20, 12}, {-20, 12}}, true};
  scene.obstacles.push_back({.chains = {around}});
  EXPECT_EQ(Simulation(scene, 1).route({0}).length, 12.0);
  scene.moving_obstacles = {disc({0, 0}, 0.5)};
  Simulation simulation(scene, 1);
  EXPECT_GT(simulation.route({0}).length, 15.0);
  EXPECT_LE(arrival(simulation, 40.0), 20.0);
  // where all are blocked, the robot waits before the nearest, and its goal can be reached later
  scene.moving_obstacles.push_back(disc({0, 6}, 0.5));
  Simulation blocked(scene, 1);
  EXPECT_EQ(blocked.route({0}).length, 12.0);
  EXPECT_TRUE(blocked.unreachable().empty());
}

// A cart comes to rest on the route of the robot while the robot drives there.
Scenario with_a_cart_that_stops() {
  Scenario scene = row_of(6, -4.5);
  MovingObstacle cart = disc({4.0, 6.5}, 0.6);
  cart.max_deviation = 1.0, cart.max_speed = 1.0;
  cart.path = {{1.5, 2.0}};
  scene.moving_obstacles.push_back(cart);
  return scene;
}

TEST(RestingMovers, are_found_as_they_come_to_rest) {
  Simulation simulation(with_a_cart_that_stops(), 1);
  for (int step = 0; step < 5; ++step) simulation.step();
  const Vec2 before = simulation.route({0}).next;
  while (simulation.time() < 12.0) simulation.step();
  for (const Vec2 place : {Vec2{-10, 0}, Vec2{-5, 1}}) {
    const RobotId robot = simulation.add_robot(robot_at(place, {10, 0}));
    EXPECT_GT(simulation.route(robot).length, norm(Vec2{10, 0} - place));
    simulation.remove_robot(robot);
  }
  EXPECT_NE(before, simulation.route({0}).next);
}

// The ways are part of what is saved, the movers that they go around are not.
TEST(RestingMovers, are_gone_around_alike_when_restored) {
  for (const int saved_at : {0, 7, 30, 60, 90}) {
    Simulation simulation(with_a_cart_that_stops(), 1);
    Simulation used(with_a_cart_that_stops(), 1);
    for (int step = 0; step < saved_at; ++step) simulation.step();
    for (int step = 0; step < 120; ++step) used.step();
    const std::vector<std::byte> saved = simulation.save();
    Simulation fresh(saved, 1);
    used.restore(saved);
    EXPECT_EQ(used.save(), saved);
    for (int step = 0; step < 150; ++step) {
      simulation.step(), fresh.step(), used.step();
      ASSERT_EQ(simulation.state_hash(), fresh.state_hash()) << saved_at << ", step " << step;
      ASSERT_EQ(simulation.state_hash(), used.state_hash()) << saved_at << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace avo
