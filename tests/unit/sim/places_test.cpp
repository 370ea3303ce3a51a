// SPDX-License-Identifier: Apache-2.0
// Robots with goals that leave no room for all of them come to rest around the place, by what they
// see.
#include "guidance/places.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "avo/simulation.h"
#include "guidance/routes.h"
#include "perceived.h"
#include "scenes.h"
#include "support/generators.h"
#include "unit/sim/rallies.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::expect_rest;
using test::robot_at;

constexpr double kReach = 1.0;  // m, of two usual robots in contact

Seeker seeker_at(Vec2 position) {
  return {.position = position, .goal = {}, .radius = 0.5, .max_speed = 2.0, .range = 100.0};
}

Occupied seen_by(const Seeker& seeker, const std::vector<Neighbor>& others) {
  Occupied occupied;
  for (const Neighbor& other : others) occupied.add(seeker, other);
  return occupied;
}

Vec2 place(const Seeker& seeker, const std::vector<Neighbor>& others,
           const std::vector<Wall>& walls = {}) {
  return place_near(seeker, seen_by(seeker, others), walls);
}

Neighbor one_at(Vec2 position, Vec2 velocity = {}) {
  return {.position = position, .velocity = velocity};
}

TEST(Places, are_goals_where_nobody_stands_on_them) {
  EXPECT_EQ(place(seeker_at({5, 0}), {}), Vec2{});
  EXPECT_EQ(place(seeker_at({5, 0}), {one_at({0, 1.001})}), Vec2{});
  EXPECT_EQ(place(seeker_at({5, 0}), {one_at({0, 0.5}, {0.5, 0})}), Vec2{}) << "it moves on";
  EXPECT_EQ(place(seeker_at({7, 0}), {one_at({0.1, 0})}), Vec2{}) << "that is far from here";
}

TEST(Places, are_beside_those_at_rest) {
  const Vec2 opposite = place(seeker_at({3, 0}), {one_at({-0.3, 0.0})});
  EXPECT_NEAR(opposite.x, 1.02 * kReach - 0.3, 1e-9);
  EXPECT_NEAR(opposite.y, 0.0, 1e-9);
  // in the notch between two
  const Vec2 notch = place(seeker_at({0.2, 4}), {one_at({-0.6, 0}), one_at({0.6, 0})});
  EXPECT_NEAR(notch.x, 0.0, 1e-9);
  EXPECT_NEAR(notch.y, std::sqrt(1.02 * 1.02 - 0.36), 1e-9);
}

// The one in sight, though there is a nearer one on the other side.
TEST(Places, are_reached_on_a_straight_way) {
  const std::vector<Neighbor> others = {one_at({0.7, -0.6}), one_at({0.7, 0.6})};
  const double notch = std::sqrt(1.02 * 1.02 - 0.36);  // m, from between them
  EXPECT_NEAR(place(seeker_at({-2.2, 0.0}), others).x, 0.7 - notch, 1e-9);
  EXPECT_NEAR(place(seeker_at({2.2, 0.0}), others).x, 0.7 + notch, 1e-9);
}

TEST(Places, are_where_the_seeker_is_that_finds_no_nearer_one) {
  for (const double distance : {1.02, 1.05}) {
    const Seeker seeker = seeker_at({distance, 0.0});
    EXPECT_EQ(place(seeker, {one_at({0.0, 0.0})}), seeker.position) << distance;
  }
  Seeker seeker = seeker_at({1.3, 0.0});
  EXPECT_NE(place(seeker, {one_at({0.0, 0.0})}), seeker.position);
  seeker.has_stood = true;  // for so little it does not set out again
  EXPECT_EQ(place(seeker, {one_at({0.0, 0.0})}), seeker.position);
}

TEST(Places, are_clear_of_walls) {
  const Wall wall{{-9, -0.55}, {9, -0.55}};
  const Vec2 open = place(seeker_at({3, -0.02}), {one_at({0.05, 0.4})});
  EXPECT_LT(open.y, -0.2);
  const Vec2 beside = place(seeker_at({3, -0.02}), {one_at({0.05, 0.4})}, {wall});
  EXPECT_GE(beside.y, -0.05);
  EXPECT_GE(norm(beside - Vec2{0.05, 0.4}), kReach);
  EXPECT_LT(norm(beside), 1.2);
}

TEST(Places, are_at_the_crowd_where_robots_at_rest_lead_to_the_goal) {
  const auto is_at = [](Vec2 position, const std::vector<Neighbor>& others) {
    const Seeker seeker = seeker_at(position);
    Occupied occupied = seen_by(seeker, others);
    return is_at_crowd(seeker, occupied);
  };
  const Neighbor on_goal = one_at({0.1, 0});
  EXPECT_TRUE(is_at({2.05, 0}, {on_goal}));
  EXPECT_FALSE(is_at({2.15, 0}, {on_goal})) << "a robot gets through between them";
  EXPECT_TRUE(is_at({5.9, 0}, {one_at({4.0, 0}), on_goal, one_at({2.05, 0})}));
  EXPECT_FALSE(is_at({5.9, 0}, {one_at({4.0, 0}), on_goal}));
  EXPECT_FALSE(is_at({5.9, 0}, {one_at({4.0, 0}), one_at({2.05, 0}), one_at({1.01, 0})}))
      << "nobody stands on the goal";
}

TEST(Places, are_at_no_crowd_behind_a_wall) {
  const std::vector<Wall> walls = {{{-9, -1.2}, {9, -1.2}}};
  const Routes routes(RouteRules{}, walls, {});
  const Seeker before = seeker_at({0, 1.8}), behind = seeker_at({0, -1.8});
  const std::vector<Neighbor> others = {one_at({0, 0})};
  Occupied seen = seen_by(before, others);
  EXPECT_TRUE(is_at_crowd(before, seen, &routes));
  seen = seen_by(behind, others);
  EXPECT_FALSE(is_at_crowd(behind, seen, &routes));
}

// Round a corner they are as near to that as there is room.
TEST(Places, are_near_what_is_next_on_the_way) {
  Seeker seeker = seeker_at({5, 0});
  seeker.goal = {0, 6}, seeker.next = {0, 0};
  const Neighbor on_goal = one_at({0, 6});
  EXPECT_EQ(place(seeker, {on_goal, one_at({4, 1.5})}), seeker.next) << "it is free";
  EXPECT_EQ(place(seeker, {one_at({0.1, 0.1}), one_at({4, 1.5})}), seeker.next)
      << "nobody stands on the goal";
  const Vec2 beside = place(seeker, {on_goal, one_at({-0.3, 0}), one_at({4, 1.5})});
  EXPECT_NEAR(beside.x, 1.02 * kReach - 0.3, 1e-9);
  EXPECT_NEAR(beside.y, 0.0, 1e-9);
  seeker.position = beside;
  EXPECT_EQ(place(seeker, {on_goal, one_at({-0.3, 0})}), beside);
}

TEST(Places, are_left_to_those_who_come_out) {
  const Seeker seeker = seeker_at({1.6, 0.0});
  const std::vector<Neighbor> inside = {one_at({0.4, 0.0}), one_at({0.55, 0.0}, {0.1, 0.0})};
  EXPECT_TRUE(seen_by(seeker, inside).comes_out);
  Detour detour;
  place_of(seeker, seen_by(seeker, inside), {}, false, detour);
  EXPECT_FALSE(detour.goal_taken);
  for (const Vec2 velocity : {Vec2{0.0, 0.0}, Vec2{-0.1, 0.0}, Vec2{0.0, 0.1}}) {
    const Occupied seen = seen_by(seeker, {one_at({0.4, 0.0}), one_at({0.55, 0.0}, velocity)});
    EXPECT_FALSE(seen.comes_out);
    place_of(seeker, seen, {}, false, detour);
    EXPECT_TRUE(detour.goal_taken);
  }
  EXPECT_FALSE(seen_by(seeker, {one_at({2.7, 0.0}, {0.1, 0.0})}).comes_out) << "from outside";
}

// From all around, or from one side, to goals that are `off` apart at most.
Scenario rally(int robots, double off, bool from_one_side, std::uint64_t seed) {
  test::Random random(seed);
  Scenario scene;
  const double outer = 6.0 + 2.0 * std::sqrt(robots);
  while (scene.robots.size() < static_cast<std::size_t>(robots)) {
    const Vec2 from{random.uniform(-outer, outer), random.uniform(-outer, outer)};
    const bool is_clear =
        std::all_of(scene.robots.begin(), scene.robots.end(),
                    [&](const RobotSetup& other) { return norm(other.position - from) > 1.3; });
    if (norm(from) < 4.0 || !is_clear || (from_one_side && from.x > -3.0)) continue;
    const Vec2 goal{random.uniform(-off, off), random.uniform(-off, off)};
    scene.robots.push_back(robot_at(from, goal));
  }
  return scene;
}

TEST(Rallies, come_to_rest_from_a_circle) {
  for (const int robots : {2, 3, 4, 6, 12, 24, 30}) {
    SCOPED_TRACE(robots);
    Scenario scene;
    for (int k = 0; k < robots; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / robots;
      scene.robots.push_back(robot_at(10.0 * Vec2{std::cos(angle), std::sin(angle)}, {}));
    }
    expect_rest(scene);
  }
}

TEST(Rallies, come_to_rest_from_anywhere) {
  for (const int robots : {2, 3, 5, 8, 20}) {
    for (const bool from_one_side : {false, true}) {
      SCOPED_TRACE(testing::Message() << robots << ' ' << from_one_side);
      expect_rest(rally(robots, 0.0, from_one_side, 7));
    }
  }
}

TEST(Rallies, come_to_rest_at_goals_that_are_nearly_the_same) {
  for (const double off : {1e-3, 0.01, 0.05, 0.3}) {
    for (const int robots : {2, 5, 12}) {
      SCOPED_TRACE(testing::Message() << off << ' ' << robots);
      expect_rest(rally(robots, off, false, 3), 0.5);
    }
  }
}

TEST(Rallies, come_to_rest_whatever_their_radii) {
  Scenario scene = rally(14, 0.0, false, 5);
  for (std::size_t k = 0; k < scene.robots.size(); ++k)
    scene.robots[k].radius = 0.2 + 0.05 * static_cast<double>(k % 8);
  expect_rest(scene);
  scene.arrival_distance = 0.05;
  expect_rest(scene);
}

TEST(Rallies, come_to_rest_beside_walls) {
  Scenario scene = rally(14, 0.0, true, 2);
  scene.obstacles = {{.chains = {{{{0.6, -30.0}, {0.6, 30.0}}}}}};
  expect_rest(scene);
}

// No robot gets nearer than there is room, and one that comes later does not put others aside.
TEST(Rallies, are_joined_from_outside) {
  const Scenario scene = rally(6, 0.0, false, 1);
  Simulation simulation(scene, 1);
  while (simulation.time() < 50.0) simulation.step();
  ASSERT_TRUE(simulation.all_at_goal());
  const FleetView fleet = simulation.fleet();
  const std::vector<Vec2> before(fleet.position.begin(), fleet.position.end());
  simulation.add_robot(robot_at({14.0, 3.0}, {}));
  while (simulation.time() < 100.0) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_EQ(simulation.fleet().position[k], before[k]) << k;
  EXPECT_EQ(simulation.fleet().velocity[6], Vec2{});
}

// Robots that cannot set out yet, because others stand around them, have not arrived.
TEST(Rallies, are_far_from_their_places_at_the_start) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0})};
  for (int k = 0; k < 25; ++k)
    scene.robots.push_back(robot_at({-6.75 - 1.05 * (k / 5), 1.05 * (k % 5 - 2)}, {0, 0}));
  Simulation simulation(scene, 1);
  simulation.step();
  for (std::size_t k = 1; k < scene.robots.size(); ++k)
    EXPECT_FALSE(simulation.is_at_goal({k})) << k;
}

TEST(Rallies, have_not_arrived_where_walls_keep_them_out) {
  Scenario scene;
  scene.obstacles = {
      test::pieces({{{0, -40}, {0, 40}}, {{0, 40}, {-40, 0}}, {{-40, 0}, {0, -40}}})};
  scene.robots = {robot_at({-6, 0}, {5, 0}), robot_at({-6, 1.5}, {5, 0})};
  Simulation simulation(scene, 1);
  while (simulation.time() < 30.0) simulation.step();
  EXPECT_EQ(simulation.unreachable().size(), 2U);
  for (const std::size_t k : {0, 1}) EXPECT_FALSE(simulation.is_at_goal({k})) << k;
}

TEST(Rallies, let_out_who_is_sent_away) {
  const Scenario scene = rally(12, 0.0, false, 4);
  Simulation simulation(scene, 1);
  while (simulation.time() < 50.0) simulation.step();
  const std::span<const Vec2> position = simulation.fleet().position;
  const auto innermost = std::min_element(position.begin(), position.end(),
                                          [](Vec2 a, Vec2 b) { return norm(a) < norm(b); });
  const auto robot = static_cast<std::size_t>(innermost - position.begin());
  simulation.set_goal({robot}, {15.0, 0.0});
  while (simulation.time() < 100.0) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_LT(norm(simulation.fleet().position[robot] - Vec2{15.0, 0.0}), 0.5);
}

TEST(Rallies, change_nothing_where_equal_goals_are_set_in_each_step) {
  const Scenario scene = rally(5, 0.0, false, 6);
  Simulation once(scene, 1), again(scene, 1);
  for (int k = 0; k < 300; ++k) {
    for (std::uint64_t robot = 0; robot < 5; ++robot) again.set_goal({robot}, {});
    once.step(), again.step();
    ASSERT_EQ(once.state_hash(), again.state_hash()) << k;
  }
  EXPECT_TRUE(again.all_at_goal());
}

TEST(Rallies, are_perceived_as_they_are_stepped_and_restored) {
  Simulation simulation(rally(5, 0.01, false, 2), 1);
  int taken = 0;
  const auto count = [&](const Simulation::Perception& seen) {
    taken += seen.detour.goal_taken ? 1 : 0;
  };
  for (int k = 0; k < 300; ++k) {
    ASSERT_NO_FATAL_FAILURE(test::step_as_perceived(simulation, count));
  }
  EXPECT_GT(taken, 100);
  Simulation restored(simulation.save(), 1);
  EXPECT_EQ(restored.all_at_goal(), simulation.all_at_goal());
  EXPECT_TRUE(restored.all_at_goal());
  for (int k = 0; k < 20; ++k) simulation.step(), restored.step();
  EXPECT_EQ(simulation.state_hash(), restored.state_hash());
}

// Each has a place of its own, and is put aside by one that goes through.
TEST(Crowds, settle_after_a_visit_however_small_the_arrival_distance_is) {
  for (const double within : {0.05, 0.1}) {
    Scenario scene;
    scene.arrival_distance = within;
    scene.robots = {robot_at({-16.0, 0.2}, {16.0, 0.2})};
    for (int k = 0; k < 36; ++k) {
      const Vec2 place{1.1 * (k % 6) - 2.75, 1.1 * (k / 6) - 2.75};
      scene.robots.push_back(robot_at(place, place));
    }
    const test::Rally visit = test::run_rally(scene, 120.0);
    EXPECT_EQ(visit.arrived, 37) << within;
    EXPECT_LT(visit.rest, 100.0) << within;
    EXPECT_EQ(visit.contacts, 0) << within;
  }
}

}  // namespace
}  // namespace avo
