// SPDX-License-Identifier: Apache-2.0
// Routes among boxes: clear, short, and found again after edits.
#include "space/routes/routes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <span>
#include <vector>

#include "avo/space/metrics.h"
#include "avo/space/reachability.h"
#include "avo/space/simulation.h"
#include "space/routes/tighten.h"
#include "unit/space/draws.h"
#include "unit/space/shortest.h"

namespace avo::space::tests {
namespace {

Robot ball(Vec3 position, double radius) {
  Robot robot;
  robot.position = position, robot.radius = radius;
  return robot;
}

// The route of a robot that has the scene for itself.
SpaceRoute route_of(const std::vector<Box>& boxes, Vec3 from, Vec3 goal, double radius) {
  const Robot robot = ball(from, radius);
  SpaceRoutes routes(boxes, std::span(&robot, 1), std::span(&goal, 1), true);
  HeadingScratch scratch;
  routes.look(0, robot, goal, scratch);
  const SpaceRoute* route = routes.route(0);
  return route != nullptr ? *route : SpaceRoute{};
}

// m: the least distance of a route from the boxes, by dense samples.
double clearance_of(const std::vector<Box>& boxes, Vec3 from, const SpaceRoute& route) {
  double least = Box::kFar;
  for (const SpaceRoutePoint& point : route.points) {
    for (int k = 0; k <= 200; ++k) {
      for (const Box& one : boxes)
        least = std::min(least, distance_of(from + (0.005 * k) * (point.place - from), one));
    }
    from = point.place;
  }
  return least;
}

// Eight boxes, half of them turned.
std::vector<Box> random_boxes(Draws& draws) {
  std::vector<Box> boxes;
  for (int k = 0; k < 8; ++k) {
    const Vec3 center{draws.between(-4, 4), draws.between(-4, 4), draws.between(-4, 4)};
    const double x = draws.between(0.1, 2.5), y = draws.between(0.1, 2.5);
    const Vec3 half{x, y, draws.between(0.1, 2.5)};
    boxes.push_back(box_of(center - half, center + half));
    if (k % 2 == 1) boxes.back().heading = draws.between(-3, 3);
  }
  return boxes;
}

// A wall with a hole of that width and height about the origin, in the plane x = 0.
std::vector<Box> wall_with_hole(double width, double height, double thickness = 0.2) {
  const double w = 0.5 * width, h = 0.5 * height, t = 0.5 * thickness;
  return {box_of({-t, -6, -6}, {t, -w, 6}), box_of({-t, w, -6}, {t, 6, 6}),
          box_of({-t, -w, -6}, {t, w, -h}), box_of({-t, -w, h}, {t, w, 6})};
}

TEST(SpaceRoutes, among_boxes_are_clear_and_hardly_longer_than_the_shortest) {
  double sum = 0.0;
  constexpr int kScenes = 12;
  for (int seed = 1; seed <= kScenes; ++seed) {
    Draws draws(static_cast<std::uint64_t>(seed));
    const std::vector<Box> boxes = random_boxes(draws);
    const Vec3 from{-8, draws.between(-4, 4), draws.between(-4, 4)};
    const Vec3 goal{8, draws.between(-4, 4), draws.between(-4, 4)};
    const SpaceRoute route = route_of(boxes, from, goal, 0.4);
    ASSERT_TRUE(route.reaches && !route.points.empty()) << seed;
    EXPECT_EQ(route.points.back().place, goal);
    EXPECT_GE(clearance_of(boxes, from, route), 0.4) << seed;
    const double shortest = shortest_length(boxes, from, goal, 0.4 + kRouteRoom, 0.25);
    const double ratio = route_length(from, route.points) / shortest;
    EXPECT_LT(ratio, 1.02) << seed;
    sum += ratio;
  }
  EXPECT_LT(sum / kScenes, 1.005);
}

// A route over the edge of a wall without end is a tangent, an arc around the edge, and a tangent.
// The route crosses the edge where the unfolded route is straight.
TEST(SpaceRoutes, over_an_edge_are_as_short_as_the_unfolded_way) {
  const std::vector<Box> wall{box_of({-0.5, -Box::kFar, -Box::kFar}, {0.5, Box::kFar, 0.0})};
  const double room = 0.5 + kRouteRoom;
  const Vec3 from{-4, -3, -2}, goal{4, 5, -2};
  const double far = std::hypot(3.5, 2.0);  // from the corner of the wall
  const double tangent = std::sqrt(far * far - room * room);
  const double touches = std::acos(room / far) - std::atan2(2.0, 3.5);  // above the horizontal
  const double arc = room * (std::acos(0.0) - touches);
  const double across = 2.0 * tangent + 2.0 * arc + 1.0;
  const double unfolded = std::hypot(across, goal.y - from.y);
  const SpaceRoute route = route_of(wall, from, goal, 0.5);
  ASSERT_TRUE(route.reaches);
  const double length = route_length(from, route.points);
  EXPECT_LT(length, 1.015 * unfolded);
  EXPECT_GT(length, 0.98 * unfolded);
}

TEST(SpaceRoutes, lead_through_a_hole_that_fits_the_robot_and_around_for_a_larger_one) {
  const std::vector<Box> wall = wall_with_hole(1.0, 1.0);
  const Vec3 from{-4, 1, 0}, goal{4, 1, 0.3};
  for (const double radius : {0.3, 0.45, 0.49, 0.51, 0.8}) {
    const SpaceRoute route = route_of(wall, from, goal, radius);
    ASSERT_TRUE(route.reaches) << radius;
    EXPECT_EQ(route_length(from, route.points) < 9.0, radius < 0.5) << radius;
    EXPECT_GE(clearance_of(wall, from, route), radius) << radius;
  }
}

TEST(SpaceRoutes, without_boxes_in_between_are_the_straight_way_to_the_last_bit) {
  const auto hash_of = [](bool navigation) {
    Scenario scene;
    scene.navigation = navigation;
    scene.boxes = {box_of({-Box::kFar, -Box::kFar, -Box::kFar}, {Box::kFar, Box::kFar, 0.0})};
    for (int k = 0; k < 6; ++k) {
      scene.robots.push_back(
          {.position = {-6, 2.0 * k, 1.0 + 0.3 * k}, .goal = {6, 10 - 2.0 * k, 2.0}});
    }
    Simulation simulation(scene);
    for (int k = 0; k < 60; ++k) simulation.step();
    return simulation.state_hash();
  };
  EXPECT_EQ(hash_of(true), hash_of(false));
}

TEST(SpaceRoutes, a_robot_in_front_of_a_wide_box_arrives_in_little_more_time_than_its_way_takes) {
  Scenario scene;
  scene.robots = {{.position = {-6, 0.3, 0.2}, .goal = {6, 0, 0}}};
  scene.boxes = {box_of({-1, -5, -5}, {1, 5, 5})};
  Simulation simulation(scene);
  const double way = simulation.route({0}).length;
  EXPECT_GT(way, 15.0);
  while (!simulation.is_at_goal({0}) && simulation.time() < 60.0) simulation.step();
  EXPECT_LT(simulation.time(), way / 2.0 + 6.0);
  scene.navigation = false;
  Simulation straight(scene);
  while (!straight.is_at_goal({0}) && straight.time() < 60.0) straight.step();
  EXPECT_GE(straight.time(), 60.0);
}

// A shell with a door that opens while the robot waits.
TEST(SpaceRoutes, to_goals_out_of_reach_end_near_them_until_a_door_opens) {
  std::vector<Box> shell = {box_of({-3, -3, -3}, {-2, 3, 3}), box_of({-2, -3, -3}, {3, -2, 3}),
                            box_of({-2, 2, -3}, {3, 3, 3}),   box_of({-2, -2, -3}, {3, 2, -2}),
                            box_of({-2, -2, 2}, {3, 2, 3}),   box_of({2, -2, -2}, {3, 2, 2})};
  Scenario scene;
  scene.robots = {{.position = {-7, 0.3, 0}, .goal = {0, 0, 0}},
                  {.position = {-7, 3, 0}, .goal = {7, 3, 0}}};
  scene.boxes = shell;
  const std::vector<OutOfReach> told = out_of_reach(scene);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].robot, RobotId{0});
  EXPECT_FALSE(told[0].is_in_box);
  EXPECT_NEAR(told[0].distance_left, 3.5, 0.1);
  Simulation simulation(scene);
  EXPECT_EQ(simulation.unreachable(), std::vector<RobotId>{{0}});
  EXPECT_TRUE(std::isinf(simulation.route({0}).length));
  for (int k = 0; k < 150; ++k) simulation.step();
  EXPECT_TRUE(simulation.is_at_goal({1}));
  EXPECT_LT(norm(simulation.robots()[0].velocity), 0.05);
  EXPECT_LT(norm(simulation.robots()[0].position), 4.0);
  shell.pop_back();
  simulation.set_boxes(shell);
  EXPECT_TRUE(simulation.unreachable().empty());
  for (int k = 0; k < 150 && !simulation.is_at_goal({0}); ++k) simulation.step();
  EXPECT_TRUE(simulation.is_at_goal({0}));
  scene.robots[0].goal = {2.5, 0, 0};
  EXPECT_TRUE(out_of_reach(scene).at(0).is_in_box);
}

TEST(SpaceRoutes, that_an_edit_leaves_clear_and_short_change_no_bit) {
  Scenario scene;
  for (int k = 0; k < 4; ++k)
    scene.robots.push_back({.position = {-6, 2.0 * k - 3, 0.2 * k}, .goal = {6, 3 - 2.0 * k, 0}});
  scene.boxes = {box_of({-1, -5, -5}, {1, 5, 5})};
  Simulation one(scene), other(scene);
  for (int k = 0; k < 20; ++k) one.step(), other.step();
  std::vector<Box> more = scene.boxes;
  more.push_back(box_of({20, 20, 20}, {21, 21, 21}));
  other.set_boxes(more);
  for (int k = 0; k < 60; ++k) one.step(), other.step();
  EXPECT_EQ(one.state_hash(), other.state_hash());
  more.push_back(box_of({-0.5, -9, 5}, {0.5, 9, 9}));  // over the box
  Simulation moved(scene);
  for (int k = 0; k < 20; ++k) moved.step();
  moved.set_boxes(more);
  for (int k = 0; k < 250; ++k) moved.step();
  for (std::size_t k = 0; k < moved.size(); ++k) EXPECT_TRUE(moved.is_at_goal({k})) << k;
}

TEST(SpaceRoutes, of_a_large_fleet_are_the_same_whatever_the_number_of_threads) {
  Scenario scene;
  Draws draws(3);
  for (int k = 0; k < 300; ++k) {
    const Vec3 cell{0.0, 1.5 * (k % 15) - 10.5, 1.5 * (k / 15) - 14.0};
    scene.robots.push_back({.position = cell - Vec3{6, 0, 0}, .goal = cell + Vec3{6, 0, 0}});
  }
  scene.boxes = {box_of({-1, -3, -3}, {1, 3, 3})};
  Simulation one(scene, 1), three(scene, 3);
  for (int k = 0; k < 10; ++k) one.step(), three.step();
  EXPECT_EQ(one.state_hash(), three.state_hash());
}

TEST(SpaceRoutes, a_goal_behind_a_thin_wall_is_not_reached_before_the_robot_is_round_it) {
  Scenario scene;
  scene.robots = {{.position = {-0.2, 0, 0}, .goal = {0.2, 0, 0}, .radius = 0.15}};
  scene.boxes = {box_of({0, -2, -2}, {0, 2, 2})};
  Simulation simulation(scene);
  EXPECT_FALSE(simulation.is_at_goal({0}));
  while (!simulation.is_at_goal({0}) && simulation.time() < 20.0) simulation.step();
  EXPECT_GT(simulation.robots()[0].position.x, 0.0);
  EXPECT_LT(simulation.time(), 8.0);
}

// Others push a robot back around two corners: it returns by the bends that it has passed.
TEST(SpaceRoutes, of_a_robot_that_is_pushed_back_still_lead_to_the_goal) {
  const std::vector<Box> boxes = {box_of({-1, -5, -5}, {1, 5, 5})};
  const Solids solids(boxes);
  const Vec3 start{-6, 0.3, 0}, goal{6, 0, 0};
  const SpaceRoute found = route_of(boxes, start, goal, 0.5);
  SpaceRoute route = found;
  std::vector<Vec3> places{start};
  for (int k = 0; k < 400 && route.points.size() > 1; ++k) {
    ASSERT_TRUE(advance(solids, places.back(), 0.5, route)) << k;
    const Vec3 way = route.points.front().place - places.back();
    places.push_back(places.back() + std::min(1.0, 0.1 / norm(way)) * way);
  }
  ASSERT_EQ(route.points.size(), 1U);
  EXPECT_FALSE(route.passed.empty());
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    ASSERT_TRUE(advance(solids, *place, 0.5, route));
    ASSERT_EQ(route.points.back().place, goal);
  }
  EXPECT_LT(route_length(start, route.points), 1.05 * route_length(start, found.points));
}

TEST(SpaceRoutes, a_new_goal_far_outside_is_reached) {
  Scenario scene;
  scene.robots = {{.position = {-4, 0, 0}, .goal = {-6, 0, 0}}};
  scene.boxes = {box_of({-1, -3, -3}, {1, 3, 3})};
  Simulation simulation(scene);
  simulation.step();
  simulation.set_goal({0}, {30, 0, 0});
  while (!simulation.is_at_goal({0}) && simulation.time() < 40.0) simulation.step();
  EXPECT_LT(simulation.time(), 28.0);
}

}  // namespace
}  // namespace avo::space::tests
