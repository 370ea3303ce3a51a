// SPDX-License-Identifier: Apache-2.0
// From what a robot saw to what is drawn: the sets must be those that the planner used.
#include <cmath>
#include <gtest/gtest.h>

#include "figures/velocity_space.h"

namespace avo::figures {
namespace {

// A robot that heads for one neighbor, with a second one in reach.
Simulation::Perception some_perception() {
  Simulation::Perception seen;
  seen.robot.velocity = {1.0, 0.2};
  seen.robot.preferred_velocity = {1.6, 0.1};
  Neighbor ahead;
  ahead.position = {6.0, 0.5};
  ahead.velocity = {-1.0, 0.0};
  Neighbor beside;
  beside.position = {2.0, -3.0};
  beside.velocity = {0.2, 0.8};
  seen.neighbors = {ahead, beside};
  seen.source = {4, -2};
  return seen;
}

TEST(Perception, half_planes_are_those_of_the_planner) {
  const Simulation::Perception seen = some_perception();
  const Planner planner(default_options(Method::avo_paper));
  const VelocitySpace space = velocity_space(seen, planner);

  PlanWorkspace workspace;
  HalfPlanes half_planes;
  const Plan plan = planner.plan(seen.robot, seen.neighbors, workspace);
  planner.collect_half_planes(seen.robot, seen.neighbors, workspace, half_planes);
  ASSERT_FALSE(half_planes.planes.empty());
  ASSERT_EQ(space.half_planes.size(), half_planes.planes.size());
  int binding = 0;
  for (std::size_t i = 0; i < half_planes.planes.size(); ++i) {
    EXPECT_EQ(space.half_planes[i].plane.normal, half_planes.planes[i].plane.normal);
    EXPECT_EQ(space.half_planes[i].plane.offset, half_planes.planes[i].plane.offset);
    EXPECT_EQ(space.half_planes[i].label, half_planes.planes[i].neighbor == 0 ? "4" : "o1");
    if (space.half_planes[i].binding) ++binding;
  }
  EXPECT_GE(binding, 1);  // the preferred velocity is forbidden, so some line is touched
  ASSERT_EQ(space.obstacles.size(), space.half_planes.size());
  for (const LabeledObstacle& each : space.obstacles) EXPECT_FALSE(each.forbids);
  ASSERT_EQ(space.points.size(), 3U);
  EXPECT_EQ(space.points[0].at, seen.robot.velocity);
  EXPECT_EQ(space.points[1].at, seen.robot.preferred_velocity);
  EXPECT_EQ(space.points[2].at, plan.new_velocity);
  EXPECT_NE(space.points[2].at, space.points[1].at);
  ASSERT_TRUE(space.acceleration_disc && space.speed_disc);
  EXPECT_EQ(space.acceleration_disc->center, seen.robot.velocity);
  EXPECT_EQ(space.acceleration_disc->radius, 4.0);
  EXPECT_EQ(space.speed_disc->radius, 2.0);
}

TEST(Perception, the_choice_of_avo_is_that_with_the_detour_that_is_remembered) {
  Simulation::Perception seen = some_perception();
  seen.neighbors[0].position = {1.6, 0.1};  // ahead of the robot, and stays there
  seen.neighbors[0].velocity = {};
  seen.robot.velocity = {};
  seen.detour.angle = 1.0;
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  Detour detour = seen.detour;
  const Plan plan = planner.plan(seen.robot, seen.neighbors, workspace, &detour);
  EXPECT_NE(plan.new_velocity, planner.plan(seen.robot, seen.neighbors, workspace).new_velocity);
  EXPECT_EQ(velocity_space(seen, planner).points[2].at, plan.new_velocity);
}

TEST(Perception, the_choice_lies_outside_of_the_drawn_obstacles) {
  Simulation::Perception seen = some_perception();
  seen.among_movers = true;
  for (Neighbor& neighbor : seen.neighbors) neighbor.behavior = Behavior::moves_on;
  seen.neighbors[0].acceleration = {0.1, -0.2};
  const Planner planner(default_options(Method::avo_paper));
  const VelocitySpace space = velocity_space(seen, planner);
  EXPECT_TRUE(space.half_planes.empty());
  ASSERT_EQ(space.obstacles.size(), 2U);
  EXPECT_DOUBLE_EQ(space.obstacles[0].offset.x, -1.0 + 4.0 * 0.1);  // v_B + δ a_B
  EXPECT_DOUBLE_EQ(space.obstacles[0].offset.y, 4.0 * -0.2);
  EXPECT_EQ(space.obstacles[1].offset, seen.neighbors[1].velocity);
  bool touched = false;
  for (const LabeledObstacle& labeled : space.obstacles) {
    const ClosestApproach closest =
        closest_approach(labeled.obstacle, space.points[2].at - labeled.offset);
    EXPECT_GE(closest.distance, labeled.obstacle.pair.radius - 1e-6);
    touched = touched || closest.distance < labeled.obstacle.pair.radius + 1e-3;
    EXPECT_TRUE(std::isfinite(closest.time));
  }
  EXPECT_TRUE(touched);  // the nearest allowed point lies on a boundary
}

// Above the wall it would pass the ones ahead below.
TEST(Perception, walls_are_drawn_and_planned_with) {
  for (const bool among_movers : {false, true}) {
    for (const Method method : {Method::avo, Method::avo_paper, Method::orca}) {
      Simulation::Perception seen = some_perception();
      seen.walls = {{{-9.0, 30.0}, {9.0, 30.0}}, {{-9.0, -0.6}, {9.0, -0.6}}};
      seen.among_movers = among_movers;
      if (among_movers)
        for (Neighbor& neighbor : seen.neighbors) neighbor.behavior = Behavior::moves_on;
      seen.robot.preferred_velocity = {1.6, -0.9};
      const Planner planner(default_options(method));
      const VelocitySpace space = velocity_space(seen, planner);
      PlanWorkspace workspace;
      Detour detour = seen.detour;
      const Plan plan = planner.plan(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
      EXPECT_EQ(space.points[2].at, plan.new_velocity);
      int forbidding = 0, others = 0;
      for (const LabeledPlane& labeled : space.half_planes) {
        if (labeled.label != "w1") continue;
        ++(labeled.forbids ? forbidding : others);
        if (labeled.forbids && method != Method::avo) {
          EXPECT_LE(violation(labeled.plane, plan.new_velocity), 1e-9);
        }
      }
      // of method avo the speed, and dashed the obstacle
      EXPECT_EQ(forbidding, method == Method::avo && among_movers ? 0 : 1) << to_string(method);
      EXPECT_EQ(others, method != Method::avo ? 0 : among_movers ? 2 : 1) << to_string(method);
    }
  }
}

TEST(Perception, velocity_obstacles_are_drawn_as_such) {
  const Planner planner(default_options(Method::velocity_obstacle));
  const VelocitySpace space = velocity_space(some_perception(), planner);
  ASSERT_EQ(space.obstacles.size(), 2U);
  EXPECT_EQ(space.obstacles[0].obstacle.response.gain(3.0), 3.0);
  EXPECT_EQ(space.obstacles[0].offset, (Vec2{-1.0, 0.0}));
}

TEST(Perception, orca_has_no_acceleration_disc) {
  const Planner planner(default_options(Method::orca));
  const VelocitySpace space = velocity_space(some_perception(), planner);
  EXPECT_FALSE(space.acceleration_disc);
  EXPECT_TRUE(space.speed_disc);
  EXPECT_FALSE(space.half_planes.empty());
}

}  // namespace
}  // namespace avo::figures
