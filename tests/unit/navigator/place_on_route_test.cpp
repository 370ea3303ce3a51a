// SPDX-License-Identifier: Apache-2.0
// A robot knows how far it is on its route or its mission: on closed routes, at stages, and where
// routes are made anew.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "avo/navigator.h"
#include "unit/navigation/buildings.h"
#include "unit/navigator/on_board.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

constexpr double kCycle = 0.1;  // s
constexpr double kForever = std::numeric_limits<double>::infinity();

// What makes routes anew while the robot drives.
enum class Change { none, map, mover, radius };
constexpr Change kChanges[] = {Change::none, Change::map, Change::mover, Change::radius};

// Far from the robots of these tests.
std::vector<StaticObstacle> far_wall() {
  return {test::pieces({{{0, -30}, {4, -30}, 0.0}})};
}

// One robot with its navigator. Every 2 s there is a change.
struct Disturbed {
  Navigator navigator;
  Change change;
  double other_radius = 0.4;  // m
  test::Base base = {};
  NavigatorDecision decision = {};
  int cycle = 0;

  explicit Disturbed(Change by = Change::none)
      : navigator(NavigatorOptions{}, far_wall()), change(by) {}
  [[nodiscard]] double time() const { return kCycle * cycle; }
  [[nodiscard]] Vec2 place() const { return base.robot.position; }
  [[nodiscard]] bool is(NavigatorStatus status) const { return decision.status == status; }

  void step() {
    const bool is_odd = (cycle / 20) % 2 != 0;
    if (change == Change::map && cycle % 20 == 0) navigator.set_obstacles(far_wall());
    if (change == Change::radius) base.robot.radius = is_odd ? 0.5 : other_radius;
    std::vector<Neighbor> seen;
    if (change == Change::mover) {
      Neighbor& walker = seen.emplace_back(Neighbor{.position = {4, -20}});
      walker.behavior = Behavior::moves_on;
      walker.velocity = is_odd ? Vec2{0.3, 0} : Vec2{};
    }
    decision = navigator.step(base.robot, seen, time());
    base.hold(navigator.planner(), decision.plan);
    ++cycle;
  }
};

TEST(PlaceOnRoute, is_kept_where_a_change_comes) {
  for (const Change change : kChanges) {
    Disturbed robot(change);
    robot.navigator.set_route({{0, 0}, {20, 0}, {0, 0}});
    double left = kForever;
    while (!robot.is(NavigatorStatus::reached) && robot.time() < 60.0) {
      robot.step();
      EXPECT_LT(robot.decision.route_left, left + 0.2) << robot.time();
      left = robot.decision.route_left;
    }
    EXPECT_TRUE(robot.is(NavigatorStatus::reached)) << static_cast<int>(change);
    EXPECT_LT(robot.time(), 32.0);
  }
}

// With another radius the corners are cut otherwise, and the route is longer or shorter.
TEST(PlaceOnRoute, is_kept_among_corners) {
  Disturbed robot(Change::radius);
  robot.other_radius = 1.6;
  std::vector<Vec2> route;
  for (int k = 0; k < 8; ++k) {
    const double x = 4.0 * k;
    route.insert(route.end(), {{x, 0.0}, {x, 8.0}, {x + 2.0, 8.0}, {x + 2.0, 0.0}});
  }
  robot.navigator.set_route(route);
  while (!robot.is(NavigatorStatus::reached) && robot.time() < 200.0) {
    robot.step();
    EXPECT_LT(test::off_route(robot.place(), route), 0.6) << robot.time();
  }
  EXPECT_TRUE(robot.is(NavigatorStatus::reached));
  EXPECT_LT(robot.time(), 170.0);
}

TEST(PlaceOnRoute, is_the_start_of_a_closed_route) {
  const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}};
  for (const Vec2 start : {Vec2{0, 0}, Vec2{-0.01, 0.05}, Vec2{-2, 1}}) {
    Disturbed robot;
    robot.base.robot.position = start;
    robot.navigator.set_route(square);
    robot.step();
    EXPECT_TRUE(robot.is(NavigatorStatus::under_way)) << start.x;
    EXPECT_GT(robot.decision.route_left, 39.0);
    Vec2 farthest{};
    while (!robot.is(NavigatorStatus::reached) && robot.time() < 60.0) {
      robot.step();
      farthest = {std::max(farthest.x, robot.place().x), std::max(farthest.y, robot.place().y)};
    }
    EXPECT_TRUE(robot.is(NavigatorStatus::reached));
    EXPECT_GT(std::min(farthest.x, farthest.y), 9.5) << "it has been at all corners";
  }
}

TEST(PlaceOnRoute, is_the_nearest_one_in_the_midst_of_a_route) {
  Disturbed robot;
  robot.base.robot.position = {6, 0.4};
  robot.navigator.set_route({{0, 0}, {10, 0}, {10, 10}});
  robot.step();
  EXPECT_NEAR(robot.decision.route_left, 14.4, 0.3);
}

TEST(Stages, lead_back_to_where_the_robot_starts) {
  Disturbed robot;
  robot.navigator.set_stages({{{10, 0}}, {{10, 10}}, {{0.2, 0}}});
  robot.step();
  EXPECT_TRUE(robot.is(NavigatorStatus::under_way));
  double farthest = 0.0;
  while (!robot.is(NavigatorStatus::reached) && robot.time() < 60.0) {
    robot.step();
    farthest = std::max(farthest, robot.place().y);
  }
  EXPECT_TRUE(robot.is(NavigatorStatus::reached));
  EXPECT_GT(farthest, 9.5);
}

// Another robot stands beside the goal, by which the stages lead before.
TEST(Stages, are_all_passed_where_the_goal_is_taken) {
  Disturbed robot;
  const std::vector<Neighbor> seen{{.position = {0.3, -0.9}}};
  robot.base.robot.position = {1.1, 0.3};
  robot.navigator.set_stages({{{2, 0}, 6.0}, {{10, 0}}, {{0, 0}}});
  double farthest = 0.0;
  for (; !robot.is(NavigatorStatus::reached) && robot.time() < 60.0; ++robot.cycle) {
    robot.decision = robot.navigator.step(robot.base.robot, seen, robot.time());
    robot.base.hold(robot.navigator.planner(), robot.decision.plan);
    farthest = std::max(farthest, robot.place().x);
  }
  EXPECT_TRUE(robot.is(NavigatorStatus::reached));
  EXPECT_GT(farthest, 9.5);
}

// The robot is near the stage at which it waits before it has been at the first one.
TEST(Stages, with_a_wait_come_after_those_before) {
  Disturbed robot;
  robot.navigator.set_stages({{{10, 0}}, {{0.2, 0}, kForever}, {{-10, 0}}});
  robot.step();
  EXPECT_TRUE(robot.is(NavigatorStatus::under_way));
  double farthest = 0.0;
  while (robot.time() < 30.0) {
    robot.step();
    farthest = std::max(farthest, robot.place().x);
  }
  EXPECT_TRUE(robot.is(NavigatorStatus::waiting));
  EXPECT_GT(farthest, 9.5);
}

TEST(Stages, are_waited_at_where_a_change_comes) {
  for (const Change change : kChanges) {
    Disturbed robot(change);
    robot.navigator.set_stages({{{3, 2}}, {{7, 0}, 7.0}, {{7, 0}, 1.0}, {{12, 3}, 3.0}, {{16, 0}}});
    double rested_first = 0.0, rested_second = 0.0;
    while (!robot.is(NavigatorStatus::reached) && robot.time() < 60.0) {
      robot.step();
      if (!robot.is(NavigatorStatus::waiting)) continue;
      (robot.place().x < 9.0 ? rested_first : rested_second) += kCycle;
    }
    EXPECT_TRUE(robot.is(NavigatorStatus::reached)) << static_cast<int>(change);
    EXPECT_NEAR(rested_first, 7.0, 0.25) << static_cast<int>(change);
    EXPECT_NEAR(rested_second, 3.0, 0.25) << static_cast<int>(change);
  }
}

TEST(Stages, keep_an_endless_wait_where_a_change_comes) {
  for (const Change change : kChanges) {
    Disturbed robot(change);
    robot.navigator.set_stages({{{4, 0}, kForever}, {{8, 0}}});
    while (robot.time() < 30.0) robot.step();
    EXPECT_TRUE(robot.is(NavigatorStatus::waiting)) << static_cast<int>(change);
    EXPECT_LT(norm(robot.place() - Vec2{4, 0}), 0.05);
    robot.navigator.go_on();
    if (change == Change::map) robot.navigator.set_obstacles(far_wall());
    while (robot.time() < 45.0) robot.step();
    EXPECT_TRUE(robot.is(NavigatorStatus::reached)) << static_cast<int>(change);
  }
}

}  // namespace
}  // namespace avo
