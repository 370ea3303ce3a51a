// SPDX-License-Identifier: Apache-2.0
// Routes with many points, as grid planners give them.
#include "navigator/simplified_route.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "avo/navigator.h"
#include "unit/navigator/on_board.h"

namespace avo {
namespace {

std::vector<Waypoint> waypoints(const std::vector<Vec2>& places) {
  std::vector<Waypoint> points;
  for (const Vec2 place : places) points.push_back({place});
  return points;
}

std::vector<Vec2> places(const std::vector<Waypoint>& points) {
  std::vector<Vec2> result;
  for (const Waypoint& point : points) result.push_back(point.place);
  return result;
}

// Steps of an 8-connected grid, at 26.6 degrees.
std::vector<Vec2> stairs(double resolution) {
  std::vector<Vec2> route{{0, 0}};
  while (route.back().x < 10.0 - 1e-9) {
    const bool rises = route.size() % 2 == 0;
    route.push_back(route.back() + Vec2{resolution, rises ? resolution : 0.0});
  }
  return route;
}

std::vector<Vec2> circle(double radius, int count) {
  std::vector<Vec2> route;
  for (int k = 0; k <= count; ++k) {
    const double angle = 1.75 * std::numbers::pi * k / count;
    route.push_back({radius * std::sin(angle), radius * (1.0 - std::cos(angle))});
  }
  return route;
}

TEST(SimplifiedRoute, leaves_out_points_within_the_deviation) {
  const std::vector<Vec2> route = circle(3.0, 400);
  const SimplifiedRoute simplified = simplified_route(waypoints(route), 0.1);
  EXPECT_LT(simplified.points.size(), 20u);
  EXPECT_EQ(simplified.points.front().place, route.front());
  EXPECT_EQ(simplified.points.back().place, route.back());
  double farthest = 0.0;
  for (const Vec2 p : route)
    farthest = std::max(farthest, test::off_route(p, places(simplified.points)));
  EXPECT_LE(simplified.deviation, 0.1);
  EXPECT_NEAR(simplified.deviation, farthest, 1e-12);
}

TEST(SimplifiedRoute, keeps_corners_and_the_order) {
  for (const std::vector<Vec2>& route : {std::vector<Vec2>{{0, 0}},
                                         {{0, 0}, {9, 0}},
                                         {{0, 0}, {9, 0}, {0, 0}},
                                         {{0, 0}, {5, 0}, {3, 0}, {9, 0}},
                                         {{0, 0}, {5, 0.3}, {9, 0}}}) {
    const SimplifiedRoute simplified = simplified_route(waypoints(route), 0.2);
    EXPECT_EQ(places(simplified.points), route);
    EXPECT_EQ(simplified.deviation, 0.0);
  }
}

TEST(SimplifiedRoute, keeps_stages_and_waits) {
  std::vector<Waypoint> points = waypoints({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}});
  points[1].stages = 1, points[3].wait = 2.0;
  const SimplifiedRoute simplified = simplified_route(points, 0.2);
  EXPECT_EQ(places(simplified.points), (std::vector<Vec2>{{0, 0}, {1, 0}, {3, 0}, {4, 0}}));
  EXPECT_EQ(simplified.points[1].stages, 1u);
  EXPECT_EQ(simplified.points[2].wait, 2.0);
}

struct Driven {
  double time = 0.0, farthest_off = 0.0;  // s, m
  NavigatorStatus status = NavigatorStatus::idle;
};

Driven drive(const std::vector<Vec2>& route, double tolerance) {
  NavigatorOptions options;
  options.route_tolerance = tolerance;
  Navigator navigator(options);
  navigator.set_route(route);
  test::Base base;
  base.robot.position = route.front();
  Driven driven;
  while (driven.status != NavigatorStatus::reached && driven.time < 60.0) {
    const NavigatorDecision decision = navigator.step(base.robot, {}, driven.time);
    driven.status = decision.status;
    base.hold(navigator.planner(), decision.plan);
    driven.farthest_off =
        std::max(driven.farthest_off, test::off_route(base.robot.position, route));
    driven.time += 0.1;
  }
  return driven;
}

TEST(DenseRoute, is_driven_as_fast_as_a_straight_one) {
  for (const double resolution : {0.02, 0.05, 0.1}) {
    const Driven driven = drive(stairs(resolution), 0.15);
    EXPECT_EQ(driven.status, NavigatorStatus::reached) << resolution;
    EXPECT_LT(driven.time, 9.0) << resolution;
    EXPECT_LT(driven.farthest_off, 0.15) << resolution;
  }
}

TEST(DenseRoute, is_kept_within_the_tolerance) {
  for (const double tolerance : {0.05, 0.15, 0.5}) {
    const Driven driven = drive(circle(4.0, 440), tolerance);
    EXPECT_EQ(driven.status, NavigatorStatus::reached) << tolerance;
    EXPECT_LT(driven.farthest_off, tolerance) << tolerance;
    EXPECT_LT(driven.time, 25.0) << tolerance;
  }
}

// The length between two such points would be 0.
TEST(Stages, may_nearly_repeat) {
  for (const double off : {0.0, 1e-300, 1e-200, 1e-160, 1e-59, 1e-12}) {
    Navigator navigator(NavigatorOptions{});
    navigator.set_stages({{{5, 0}}, {{5, off}}, {{5, 5}}});
    const NavigatorDecision decision = navigator.step(Robot{}, {}, 0.0);
    EXPECT_EQ(decision.plan.status, PlanStatus::optimal) << off;
    EXPECT_NEAR(decision.route_left, 10.0, 0.5) << off;
  }
}

TEST(GivenRoute, takes_points_that_nearly_repeat) {
  for (const double off : {0.0, 1e-300, 1e-200, 1e-160, 1e-59, 1e-12}) {
    const Driven driven = drive({{0, 0}, {5, 0}, {5 - off, off}, {5, 5}, {5, 5 + off}}, 0.15);
    EXPECT_EQ(driven.status, NavigatorStatus::reached) << off;
    EXPECT_LT(driven.time, 15.0) << off;
  }
}

}  // namespace
}  // namespace avo
