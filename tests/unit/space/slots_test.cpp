// SPDX-License-Identifier: Apache-2.0
// Robots that meet between two upright walls, at exactly the same height: they can only pass above
// and below each other.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "space/turn_axis.h"
#include "unit/space/runs.h"

namespace avo::space::tests {
namespace {

// Two walls at all heights, 40 m long, with that width between them, m; turned by an angle.
std::vector<Box> walls(double width, double angle) {
  const double half = 0.5 * width;
  return {{{-20, half, -Box::kFar}, {20, half, Box::kFar}, angle, 0.0},
          {{-20, -half, -Box::kFar}, {20, -half, Box::kFar}, angle, 0.0}};
}

Vec3 along(double x, double angle) {
  return {x * std::cos(angle), x * std::sin(angle), 2.0};
}

RobotSetup from_to(double start, double goal, double angle) {
  return {.position = along(start, angle), .goal = along(goal, angle), .radius = 0.4};
}

TEST(SpaceSlots, let_robots_pass_above_each_other) {
  for (const double width : {1.0, 1.3, 1.7}) {
    for (const double angle : {0.0, 0.7, 1.5707963267948966, 3.0}) {
      SCOPED_TRACE(testing::Message() << width << " m, " << angle);
      Scenario scene{.duration = 60.0};
      scene.boxes = walls(width, angle);
      scene.robots = {from_to(-5, 5, angle), from_to(5, -5, angle)};
      const RunSummary summary = summary_of(scene, RunUntil::all_arrive);
      EXPECT_EQ(summary.arrived, 2);
      EXPECT_EQ(summary.collision_pairs, 0);
      EXPECT_LT(summary.last_arrival.value_or(99.0), 10.0);
    }
  }
}

TEST(SpaceSlots, let_robots_change_places) {
  Scenario scene{.duration = 60.0};
  scene.boxes = walls(1.6, 0.0);
  const double starts[] = {-9, -5, -1, 3, 5, 7}, goals[] = {5, 7, -9, -5, 3, -1};
  for (int k = 0; k < 6; ++k) scene.robots.push_back(from_to(starts[k], goals[k], 0.0));
  const RunSummary summary = summary_of(scene, RunUntil::all_arrive);
  EXPECT_EQ(summary.arrived, 6);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_LT(summary.last_arrival.value_or(99.0), 25.0);
}

// The normal counts where two robots do not fit side by side, and has one sign for both courses.
TEST(SpaceSlots, turn_the_axis_where_they_are_narrow) {
  Robot robot;
  robot.radius = 0.5, robot.preferred_velocity = {1, 0, 0.2};
  const Vec3 across = turn_axis(robot, walls(1.5, 0.0));
  EXPECT_NEAR(std::abs(across.y), 1.0, 1e-12);
  robot.preferred_velocity = {-1, 0, 0.2};
  EXPECT_EQ(turn_axis(robot, walls(1.5, 0.0)), across);
  EXPECT_EQ(turn_axis(robot, walls(2.5, 0.0)), axis_across(robot.preferred_velocity));
  EXPECT_EQ(turn_axis(robot, {}), axis_across(robot.preferred_velocity));
  std::vector<Box> tube = walls(1.5, 0.0);
  tube.push_back({{-20, -20, -20}, {20, 20, -0.75}, 0.0, 0.0});
  tube.push_back({{-20, -20, 0.75}, {20, 20, 20}, 0.0, 0.0});
  EXPECT_EQ(turn_axis(robot, tube), axis_across(robot.preferred_velocity)) << "of the passage";
  robot.preferred_velocity = {0, 1, 0};
  EXPECT_EQ(turn_axis(robot, walls(1.5, 0.0)), axis_across(robot.preferred_velocity)) << "across";
}

}  // namespace
}  // namespace avo::space::tests
