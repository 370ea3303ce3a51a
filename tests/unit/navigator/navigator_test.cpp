// SPDX-License-Identifier: Apache-2.0
// One robot on board: it comes to its goal and rests there.
#include "avo/navigator.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/refusal.h"
#include "unit/navigation/buildings.h"
#include "unit/navigator/on_board.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::OnBoard;

// A robot that starts across the direction of its goal, as fast as it can.
Scenario alone(Vec2 goal, Vec2 velocity) {
  Scenario scene;
  scene.robots = {test::robot_at({0, 0}, goal)};
  scene.robots[0].velocity = velocity;
  return scene;
}

TEST(Navigator, comes_to_rest_at_its_goal_and_does_not_circle) {
  for (const Vec2 velocity : {Vec2{0, 0}, Vec2{0, 2}, Vec2{-2, 0}, Vec2{2, 0}}) {
    OnBoard fleet(alone({6, 0}, velocity));
    double least = 10.0, farthest_after = 0.0;
    while (fleet.time < 20.0) {
      fleet.step();
      const double left = norm(fleet.bases[0].robot.position - Vec2{6, 0});
      least = std::min(least, left);
      if (least < 0.5) farthest_after = std::max(farthest_after, left);
    }
    EXPECT_LT(farthest_after, 0.5) << "it came near and left again";
    EXPECT_LT(least, 1e-6);
    EXPECT_EQ(fleet.bases[0].robot.velocity, Vec2{});
    EXPECT_EQ(fleet.decisions[0].status, NavigatorStatus::reached);
    EXPECT_LT(fleet.decisions[0].route_left, 1e-6);
  }
}

TEST(Navigator, finds_its_way_among_walls) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::two_rooms(2.0))};
  scene.robots = {test::robot_at({9, 9}, {11, 9})};
  OnBoard fleet(scene);
  fleet.step();
  EXPECT_GT(fleet.decisions[0].route_left, 6.0);
  const std::vector<Vec2> route = fleet.navigators[0].route();
  EXPECT_GT(route.size(), 2u);
  EXPECT_EQ(route.back(), (Vec2{11, 9}));
  double left = fleet.decisions[0].route_left;
  while (!fleet.all_reached() && fleet.time < 30.0) {
    fleet.step();
    EXPECT_LT(fleet.decisions[0].route_left, left + 0.05);
    left = fleet.decisions[0].route_left;
  }
  EXPECT_LT(fleet.time, 12.0);
  while (fleet.time < 20.0) fleet.step();
  EXPECT_LT(norm(fleet.bases[0].robot.position - Vec2{11, 9}), 1e-6);
}

TEST(Navigator, without_a_goal_comes_to_rest) {
  Navigator navigator(NavigatorOptions{});
  test::Base base;
  base.robot.velocity = {2, 0};
  for (int k = 0; k < 60; ++k) {
    const NavigatorDecision decision = navigator.step(base.robot, {}, 0.1 * k);
    EXPECT_EQ(decision.status, NavigatorStatus::idle);
    base.hold(navigator.planner(), decision.plan);
  }
  EXPECT_EQ(base.robot.velocity, Vec2{});
}

TEST(Navigator, tells_how_far_it_needs_to_stop) {
  Navigator navigator(NavigatorOptions{});
  Robot robot{.velocity = {2, 0}};
  EXPECT_NEAR(navigator.step(robot, {}, 0.0).stopping_distance, 2.0, 0.02);
  robot.max_braking = 4.0;
  EXPECT_NEAR(navigator.step(robot, {}, 0.1).stopping_distance, 0.5, 0.06);
}

TEST(Navigator, tells_of_a_goal_that_it_cannot_reach) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::ring({{4, -2}, {8, -2}, {8, 2}, {4, 2}}))};
  scene.robots = {test::robot_at({0, 0}, {6, 0})};
  OnBoard fleet(scene);
  fleet.step();
  EXPECT_EQ(fleet.decisions[0].status, NavigatorStatus::unreachable);
  EXPECT_NEAR(fleet.decisions[0].distance_left, 2.5, 1e-3);
}

TEST(Navigator, makes_no_progress_where_another_stands_in_a_door) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::doorway(1.2))};
  scene.robots = {test::robot_at({-6, 0}, {6, 0}), test::robot_at({0, 0}, {0, 0})};
  OnBoard fleet(scene);
  fleet.navigators[1].clear_goal();
  bool was_stuck = false;
  while (fleet.time < 30.0 && !was_stuck) {
    fleet.step();
    was_stuck = fleet.decisions[0].status == NavigatorStatus::stuck;
  }
  EXPECT_TRUE(was_stuck);
  EXPECT_GE(fleet.decisions[0].without_progress, 10.0 - 1e-9);
}

// The goals of others are not known: another that stands on the goal for a while stays there.
TEST(Navigator, rests_beside_another_that_stands_on_its_goal) {
  Scenario scene;
  scene.robots = {test::robot_at({-6, 0.2}, {0, 0}), test::robot_at({0, 0}, {0, 0})};
  OnBoard fleet(scene);
  while (fleet.time < 40.0) fleet.step();
  const Robot& robot = fleet.bases[0].robot;
  EXPECT_EQ(fleet.decisions[0].status, NavigatorStatus::reached);
  EXPECT_EQ(robot.velocity, Vec2{});
  EXPECT_LT(norm(robot.position), 1.1);
  EXPECT_EQ(fleet.bases[1].robot.velocity, Vec2{}) << "both rest";
}

TEST(Navigator, stops_within_the_arrival_distance_of_a_goal_that_others_have) {
  Scenario scene;
  for (int k = 0; k < 5; ++k) scene.robots.push_back(test::robot_at({-6.0 - 2.0 * k, 1.0 * k}, {}));
  OnBoard fleet(scene);
  for (Navigator& navigator : fleet.navigators) navigator.set_goal({0, 0}, {}, true);
  while (fleet.time < 60.0) fleet.step();
  for (std::size_t k = 0; k < fleet.bases.size(); ++k) {
    EXPECT_EQ(fleet.decisions[k].status, NavigatorStatus::reached) << k;
    EXPECT_EQ(fleet.bases[k].robot.velocity, Vec2{}) << k;
  }
}

// The row leaves a gap aside; straight on the robot would stand before it for ever.
TEST(Navigator, goes_around_movers_at_rest) {
  Navigator navigator(NavigatorOptions{});
  navigator.set_goal({12, 0});
  test::Base base;
  std::vector<Neighbor> row;
  for (int k = -4; k <= 4; ++k) {
    Neighbor one{.position = {6, 1.1 * k}};
    one.behavior = Behavior::moves_on;
    row.push_back(one);
  }
  NavigatorStatus status = NavigatorStatus::idle;
  for (int k = 0; k < 300 && status != NavigatorStatus::reached; ++k) {
    const NavigatorDecision decision = navigator.step(base.robot, row, 0.1 * k);
    base.hold(navigator.planner(), decision.plan);
    status = decision.status;
  }
  EXPECT_EQ(status, NavigatorStatus::reached);
}

TEST(Navigator, takes_another_map) {
  Navigator navigator(NavigatorOptions{});
  navigator.set_goal({6, 0});
  const Robot robot;
  EXPECT_NEAR(navigator.step(robot, {}, 0.0).route_left, 6.0, 1e-12);
  navigator.set_obstacles({test::pieces({{{3, -4}, {3, 4}, 0.0}})});
  EXPECT_GT(navigator.step(robot, {}, 0.1).route_left, 9.0);
  EXPECT_EQ(navigator.route().back(), (Vec2{6, 0}));
  navigator.set_obstacles({});
  EXPECT_NEAR(navigator.step(robot, {}, 0.2).route_left, 6.0, 1e-12);
}

// Hosts say the goal at each cycle; the robot does not forget what it remembers.
TEST(Navigator, has_the_goal_that_it_is_told_again) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::doorway(1.2))};
  scene.robots = {test::robot_at({-6, 0}, {6, 0}), test::robot_at({0, 0}, {0, 0})};
  OnBoard once(scene), often(scene);
  once.navigators[1].clear_goal(), often.navigators[1].clear_goal();
  while (once.time < 15.0) {
    often.navigators[0].set_goal({6, 0});
    once.step(), often.step();
    EXPECT_EQ(often.decisions[0].plan.next_velocity, once.decisions[0].plan.next_velocity);
    EXPECT_EQ(often.decisions[0].without_progress, once.decisions[0].without_progress);
  }
  EXPECT_GT(often.decisions[0].without_progress, 5.0);
}

TEST(Navigator, says_why_it_waits) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots = {test::robot_at({-7, 0}, {10, 3}), test::robot_at({12, 0}, {-10, 3})};
  OnBoard fleet(scene);
  std::string sentence;
  while (fleet.time < 20.0 && !fleet.decisions[1].wait) fleet.step();
  ASSERT_TRUE(fleet.decisions[1].wait);
  EXPECT_EQ(fleet.decisions[1].wait->neighbor, 0);
  EXPECT_EQ(fleet.decisions[1].guide, Guide::passage);
  const std::vector<Neighbor> seen{test::seen_of(fleet.bases[0].robot)};
  sentence = fleet.navigators[1].explain(fleet.bases[1].robot, seen).sentence;
  EXPECT_NE(sentence.find("wait at the door between"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("for robot 0"), std::string::npos) << sentence;
}

TEST(Navigator, explains_the_decision_that_it_makes_next) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::doorway(1.6))};
  for (int k = 0; k < 3; ++k) {
    scene.robots.push_back(test::robot_at({-4.0 - 1.5 * k, 0.4 * k}, {6.0 + 1.5 * k, 0}));
    scene.robots.push_back(test::robot_at({4.0 + 1.5 * k, 0.3 * k}, {-6.0 - 1.5 * k, 0}));
  }
  OnBoard fleet(scene);
  for (int k = 0; k < 100; ++k) {
    std::vector<Neighbor> seen;
    for (std::size_t other = 1; other < fleet.bases.size(); ++other)
      seen.push_back(test::seen_of(fleet.bases[other].robot));
    const Explanation explanation = fleet.navigators[0].explain(fleet.bases[0].robot, seen);
    fleet.step();
    EXPECT_EQ(explanation.decision.plan.next_velocity, fleet.decisions[0].plan.next_velocity) << k;
    EXPECT_EQ(explanation.seen.guide, fleet.decisions[0].guide) << k;
  }
}

// Two robots at a door. Questions about a larger robot, and about a mover at rest, change nothing.
TEST(Navigator, decides_as_if_it_had_not_been_asked) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::doorway(1.6))};
  scene.robots = {test::robot_at({-6, 0.3}, {6, 0}), test::robot_at({6, 0.1}, {-6, 0})};
  OnBoard silent(scene), asked(scene);
  for (OnBoard* fleet : {&silent, &asked}) {  // that do not know the radii of others
    for (std::size_t i = 0; i < 2; ++i) {
      fleet->navigators[i] = Navigator({.id = {i}}, scene.obstacles);
      fleet->navigators[i].set_goal(scene.robots[i].goal);
    }
  }
  Neighbor mover{.position = {3, 0}};
  mover.behavior = Behavior::moves_on;
  bool waits = false;
  for (int k = 0; k < 150; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      Robot larger = asked.bases[i].robot;
      (void)asked.navigators[i].explain(larger, {&mover, 1});
      larger.radius = 0.9;
      (void)asked.navigators[i].explain(larger, {});
    }
    silent.step(), asked.step();
    waits = waits || silent.decisions[0].wait || silent.decisions[1].wait;
    for (std::size_t i = 0; i < 2; ++i)
      ASSERT_EQ(asked.decisions[i].plan.next_velocity, silent.decisions[i].plan.next_velocity) << k;
  }
  EXPECT_TRUE(waits);
}

TEST(Navigator, brakes_on_values_out_of_range) {
  Navigator navigator(NavigatorOptions{});
  navigator.set_goal({5, 0});
  const Robot robot{.velocity = {1, 0}};
  const std::vector<Neighbor> bad{{.position = {NAN, 0}}};
  EXPECT_EQ(navigator.step(robot, bad, 0.0).plan.status, PlanStatus::invalid_input);
  EXPECT_EQ(navigator.step(robot, {}, 1.0).plan.status, PlanStatus::optimal);
  const Plan late = navigator.step(robot, {}, 0.5).plan;
  EXPECT_EQ(late.status, PlanStatus::invalid_input) << "the time goes back";
  EXPECT_NEAR(late.next_velocity.x, 0.9, 1e-12);
}

TEST(Navigator, refuses_what_is_out_of_range) {
  NavigatorOptions options;
  options.yaw_goal_tolerance = 0.0;
  EXPECT_EQ(test::refusal([&] { Navigator{options}; }),
            "NavigatorOptions.yaw_goal_tolerance: found 0, must be > 0 rad");
  Navigator navigator(NavigatorOptions{});
  EXPECT_EQ(test::refusal([&] {
              navigator.set_route({{0, 0}});
            }),
            "Navigator: route: found 1 points, must be >= 2 points");
  EXPECT_EQ(test::refusal([&] { navigator.set_stages({}); }),
            "Navigator: stages: found none, must be one or more");
}

}  // namespace
}  // namespace avo
