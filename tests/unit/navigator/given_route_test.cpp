// SPDX-License-Identifier: Apache-2.0
// Routes of another planner, stages, and goals with a heading.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "avo/navigator.h"
#include "core/plane.h"
#include "support/generators.h"
#include "unit/navigation/buildings.h"
#include "unit/navigator/on_board.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

constexpr double kStep = 0.1;  // s

// One robot with its navigator, alone.
struct Alone {
  Navigator navigator;
  test::Base base;
  NavigatorDecision decision;
  double time = 0.0;

  explicit Alone(const NavigatorOptions& options = {}, std::vector<StaticObstacle> map = {})
      : navigator(options, std::move(map)) {}
  void step(std::span<const Neighbor> seen = {}) {
    decision = navigator.step(base.robot, seen, time);
    base.hold(navigator.planner(), decision.plan);
    time += kStep;
  }
};

struct Followed {
  double time = 0.0, farthest_off = 0.0, slowest = 10.0;  // s, m, m/s along the route
};

Followed follow(Alone& robot, const std::vector<Vec2>& route, double most) {
  Followed result;
  while (robot.decision.status != NavigatorStatus::reached && robot.time < most) {
    robot.step();
    result.farthest_off =
        std::max(result.farthest_off, test::off_route(robot.base.robot.position, route));
    if (robot.time > 2.0 && robot.decision.route_left > 2.5)
      result.slowest = std::min(result.slowest, norm(robot.base.robot.velocity));
  }
  result.time = robot.time;
  return result;
}

TEST(GivenRoute, is_followed_within_its_tolerance) {
  const std::vector<Vec2> route{{0, 0}, {8, 0}, {8, 8}, {16, 8}, {13, 0}, {22, 0}};
  for (const double tolerance : {0.05, 0.15, 0.5}) {
    NavigatorOptions options;
    options.route_tolerance = tolerance;
    Alone robot(options);
    robot.navigator.set_route(route);
    const Followed followed = follow(robot, route, 60.0);
    EXPECT_EQ(robot.decision.status, NavigatorStatus::reached);
    EXPECT_LT(followed.farthest_off, tolerance) << tolerance;
    EXPECT_GT(followed.slowest, 0.05) << "it need not stop at corners";
  }
}

// Any corners, limits and tolerances: most routes are kept within the tolerance.
TEST(GivenRoute, is_followed_by_robots_of_any_limits) {
  test::Random random(8);
  int beyond = 0;
  double worst = 0.0;
  for (int k = 0; k < 300; ++k) {
    std::vector<Vec2> route{{0, 0}};
    for (int piece = 0; piece < 2 + k % 6; ++piece)
      route.push_back(route.back() + random.uniform(1.0, 6.0) * random.direction());
    NavigatorOptions options;
    options.route_tolerance = random.uniform(0.05, 0.5);
    Alone robot(options);
    robot.base.robot.max_speed = random.uniform(0.4, 3.0);
    robot.base.robot.max_acceleration = random.uniform(0.5, 4.0);
    robot.navigator.set_route(route);
    const Followed followed = follow(robot, route, 200.0);
    EXPECT_EQ(robot.decision.status, NavigatorStatus::reached) << k;
    const double part = followed.farthest_off / *options.route_tolerance;
    worst = std::max(worst, part);
    if (part > 1.0) ++beyond;
  }
  RecordProperty("beyond", beyond);
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(beyond, 25);
  EXPECT_LT(worst, 2.5);
}

TEST(GivenRoute, is_left_at_its_end_alone) {
  const std::vector<Vec2> route{{0, 0}, {6, 0}, {6, 6}};
  Alone robot;
  robot.navigator.set_route(route);
  double left = 12.5;
  while (robot.time < 20.0) {
    robot.step();
    EXPECT_LE(robot.decision.route_left, left + 1e-9);
    left = robot.decision.route_left;
  }
  EXPECT_LT(norm(robot.base.robot.position - Vec2{6, 6}), 1e-6);
  EXPECT_EQ(robot.base.robot.velocity, Vec2{});
}

// Where the route leads back beside itself, the robot does not take the short cut.
TEST(GivenRoute, is_followed_in_order) {
  const std::vector<Vec2> route{{0, 0}, {10, 0}, {10, 0.6}, {0, 0.6}, {0, 4}};
  Alone robot;
  robot.navigator.set_route(route);
  double farthest = 0.0;
  while (robot.decision.status != NavigatorStatus::reached && robot.time < 60.0) {
    robot.step();
    farthest = std::max(farthest, robot.base.robot.position.x);
  }
  EXPECT_EQ(robot.decision.status, NavigatorStatus::reached);
  EXPECT_GT(farthest, 9.5);
}

TEST(GivenRoute, is_found_again_behind_a_wall) {
  const std::vector<StaticObstacle> map{test::pieces({{{-4, 1.5}, {4, 1.5}, 0.0}})};
  Alone robot({}, map);
  robot.base.robot.position = {0, 3};
  robot.navigator.set_route({{-2, 0}, {12, 0}});
  while (robot.decision.status != NavigatorStatus::reached && robot.time < 30.0) robot.step();
  EXPECT_EQ(robot.decision.status, NavigatorStatus::reached);
}

// Two robots on routes of another planner through one door.
TEST(GivenRoute, leads_through_a_door_in_turn) {
  const std::vector<StaticObstacle> map{test::pieces(test::doorway(1.4))};
  NavigatorOptions options;
  Alone a(options, map), b(options, map);
  a.base.robot.position = {-6, 0.2}, b.base.robot.position = {6.3, -0.2};
  a.navigator.set_route({{-6, 0.2}, {0, 0}, {6, 3}}),
      b.navigator.set_route({{6.3, -0.2}, {0, 0}, {-6, 3}});
  bool waited = false;
  while (a.time < 40.0 && !(a.decision.status == NavigatorStatus::reached &&
                            b.decision.status == NavigatorStatus::reached)) {
    const std::vector<Neighbor> see_b{test::seen_of(b.base.robot)};
    const std::vector<Neighbor> see_a{test::seen_of(a.base.robot)};
    a.step(see_b), b.step(see_a);
    waited = waited || b.decision.wait || a.decision.wait;
  }
  EXPECT_TRUE(waited);
  EXPECT_LT(a.time, 15.0);
}

TEST(Stages, are_passed_or_rested_at) {
  const std::vector<StaticObstacle> map{test::pieces(test::doorway(2.0))};
  Alone robot({}, map);
  robot.base.robot.position = {-8, -4};
  robot.navigator.set_stages({{{-4, 4}}, {{3, 0}, 5.0}, {{8, -4}}});
  double nearest_first = 10.0, rested = 0.0, slow = 10.0;
  while (robot.decision.status != NavigatorStatus::reached && robot.time < 60.0) {
    robot.step();
    const Robot& now = robot.base.robot;
    nearest_first = std::min(nearest_first, norm(now.position - Vec2{-4, 4}));
    if (robot.decision.status == NavigatorStatus::waiting) {
      rested += kStep;
      EXPECT_LT(norm(now.position - Vec2{3, 0}), 0.01);
    }
    if (now.position.x < -1.0 && robot.time > 2.0) slow = std::min(slow, norm(now.velocity));
  }
  EXPECT_EQ(robot.decision.status, NavigatorStatus::reached);
  EXPECT_LT(nearest_first, 0.25);
  EXPECT_NEAR(rested, 5.0, 0.2);
  EXPECT_GT(slow, 0.3);
}

TEST(Stages, hold_until_the_host_says_go_on) {
  Alone robot;
  robot.navigator.set_stages({{{4, 0}, std::numeric_limits<double>::infinity()}, {{8, 0}}});
  while (robot.time < 20.0) robot.step();
  EXPECT_EQ(robot.decision.status, NavigatorStatus::waiting);
  EXPECT_LT(norm(robot.base.robot.position - Vec2{4, 0}), 0.01);
  robot.navigator.go_on();
  while (robot.time < 30.0) robot.step();
  EXPECT_EQ(robot.decision.status, NavigatorStatus::reached);
}

struct Wheels {
  const char* name;
  MotionModel model;
};

// The largest angle, rad, by which the robot stands off, over headings all around.
double worst_heading(const MotionModel& model, Vec2 goal) {
  double worst = 0.0;
  for (int k = 0; k < 16; ++k) {
    const double heading = std::numbers::pi * (k / 8.0 - 1.0);
    Alone robot;
    Robot& self = robot.base.robot;
    self.model = model;
    self.radius = disc_radius(model, 0.5);
    self.position = disc_center(model, {}, 0.0);
    robot.navigator.set_goal(goal, heading);
    const auto rests = [&] {
      return robot.decision.status == NavigatorStatus::reached && self.velocity == Vec2{};
    };
    while (robot.time < 60.0 && !rests()) robot.step();
    EXPECT_TRUE(rests()) << heading;
    const Vec2 place = self.position - disc_center(model, {}, self.heading);
    EXPECT_LT(norm(place - goal), 0.2) << heading;
    worst = std::max(worst, std::abs(wrapped(self.heading - heading)));
  }
  return worst;
}

TEST(GoalHeading, is_that_of_a_robot_with_wheels_at_its_goal) {
  const Wheels all[] = {{"drive", DifferentialDrive{}},
                        {"car that turns on the spot", Car{}},
                        {"car", Car{.max_curvature = 0.8}},
                        {"car that reverses", Car{.max_curvature = 0.8, .reverse = true}},
                        {"car with a body", Car{.max_curvature = 0.8, .body = CarBody{0.4, 0.7}}}};
  for (const Wheels& wheels : all) {
    const double worst =
        std::max(worst_heading(wheels.model, {8, 0}), worst_heading(wheels.model, {-3, 9}));
    EXPECT_LT(worst, 0.12) << wheels.name;
    RecordProperty(wheels.name, std::to_string(worst));
  }
}

// The map is empty, or has a wall far away.
TEST(GivenRoutes, lead_around_a_person_who_stands_on_them) {
  for (const bool has_map : {false, true}) {
    for (const double max_speed : {0.5, 1.0, 2.0}) {
      for (const double radius : {0.3, 0.5}) {
        SCOPED_TRACE(testing::Message() << has_map << ' ' << max_speed << ' ' << radius);
        std::vector<StaticObstacle> map;
        if (has_map) map.push_back(test::pieces({{{-5, 6}, {15, 6}, 0.0}}));
        Alone alone({}, map);
        alone.navigator.set_route({{0, 0}, {10, 0}});
        alone.base.robot.radius = radius, alone.base.robot.max_speed = max_speed;
        Neighbor person{.position = {5, 0}, .radius = 0.3};
        person.behavior = Behavior::moves_on;
        double least = 9.0;  // m
        while (alone.time < 40.0 && alone.decision.status != NavigatorStatus::reached) {
          alone.step({&person, 1});
          least = std::min(least, norm(alone.base.robot.position - person.position) - radius - 0.3);
        }
        EXPECT_EQ(alone.decision.status, NavigatorStatus::reached);
        EXPECT_GT(least, 0.0);
        EXPECT_LT(alone.time, 10.0 / max_speed + 5.0);
      }
    }
  }
}

}  // namespace
}  // namespace avo
