// SPDX-License-Identifier: Apache-2.0
// Near its goal a robot looks less far ahead (docs/space.md, "Arriving").
#include "space/horizons.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>

#include "avo/space/planner.h"

namespace avo::space::tests {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

Robot at_distance(double left) {
  Robot robot;
  robot.max_speed = 2.0;
  robot.distance_to_goal = left;
  return robot;
}

TEST(SpaceHorizons, are_half_as_long_near_the_goal) {
  const PlannerOptions options{.time_horizon = 3.0};
  EXPECT_EQ(own_time_horizon(at_distance(kFar), options), 3.0);
  EXPECT_EQ(own_time_horizon(at_distance(10.5), options), 3.0);
  EXPECT_EQ(own_time_horizon(at_distance(7.5), options), 1.5);
  EXPECT_EQ(own_time_horizon(at_distance(0.0), options), 1.5);
  double last = 3.0;
  for (double left = 10.5; left > 7.5; left -= 0.05) {
    const double now = own_time_horizon(at_distance(left), options);
    EXPECT_LE(now, last);
    EXPECT_GE(now, last - 0.1);  // no jumps, which would be felt
    last = now;
  }
  EXPECT_EQ(own_time_horizon(at_distance(0.0), {.time_horizon = 0.15}), 0.1);  // a step
}

TEST(SpaceHorizons, of_a_decision_are_those_that_are_told) {
  const PlannerOptions options;
  const std::vector<Horizon> horizons = horizons_of(options);
  for (const double left : {0.0, 7.9, 8.6, 9.2, 10.0, kFar}) {
    const Robot robot = at_distance(left);
    EXPECT_EQ(horizon_of(robot, horizons).end().time, own_time_horizon(robot, options)) << left;
  }
}

// Both robots are far from their goals in the eyes of most other rules: 20 radii and more. From 16
// m on, the turn to the right does not fade either.
TEST(SpaceHorizons, let_a_robot_near_its_goal_fly_closer_to_others) {
  const Planner planner(PlannerOptions{});
  const std::array<Neighbor, 1> ahead{Neighbor{.position = {2.5, 0.0, 0.0}}};
  const auto speed_at = [&](double left) {
    Robot robot = at_distance(left);
    robot.radius = 0.3;
    robot.velocity = robot.preferred_velocity = {0.6, 0.0, 0.0};
    PlanWorkspace workspace;
    return planner.plan(robot, ahead, workspace).new_velocity.x;
  };
  EXPECT_GT(speed_at(7.4), speed_at(17.0) + 0.05);
  EXPECT_EQ(speed_at(17.0), speed_at(kFar));
}

}  // namespace
}  // namespace avo::space::tests
