// SPDX-License-Identifier: Apache-2.0
// Giving way (docs/arrival.md, rule 2): whom a robot makes room for, and where it stays.
#include "planner/arrival.h"

#include <gtest/gtest.h>

#include "avo/planner.h"

namespace avo {
namespace {

Robot at_distance(double distance_to_goal) {
  Robot robot;
  robot.distance_to_goal = distance_to_goal;
  return robot;
}

// Nearly in contact, to the right of it.
Neighbor beside(Vec2 velocity, double radius = 0.5) {
  return {.position = {0.5 + radius + 0.05, 0.0}, .velocity = velocity, .radius = radius};
}

double push(const Robot& robot, const Neighbor& neighbor) {
  const Vec2 push = push_of(robot, neighbor);
  EXPECT_LE(push.x, 0.0);
  EXPECT_EQ(push.y, 0.0);
  return -push.x;
}

TEST(GiveWay, near_its_goal_to_those_that_move) {
  const Robot robot = at_distance(0.1);
  EXPECT_EQ(push(robot, beside({})), 0.0);
  EXPECT_EQ(push(robot, beside({0.0, 0.01 * robot.max_speed})), 0.0);
  const double full = push(robot, beside({0.0, 0.2 * robot.max_speed}));
  EXPECT_NEAR(push(robot, beside({0.0, 0.105 * robot.max_speed})), 0.5 * full, 1e-12);
  EXPECT_EQ(push(robot, beside({0.0, robot.max_speed})), full);
  EXPECT_GT(full, 0.7);
}

TEST(GiveWay, near_its_goal_to_larger_ones_at_rest) {
  const Robot robot = at_distance(0.1);
  EXPECT_GT(push(robot, beside({}, 0.6)), 0.7);
}

TEST(GiveWay, on_its_way_less_and_to_all) {
  const Robot robot = at_distance(50.0);
  EXPECT_EQ(push(robot, beside({})), push(robot, beside({0.0, 1.0})));
  EXPECT_NEAR(push(robot, beside({})) / push(at_distance(0.0), beside({0.0, 1.0})), 0.3, 1e-12);
}

TEST(GiveWay, to_smaller_ones_less) {
  Robot robot = at_distance(50.0);
  const double equal = push(robot, beside({}));
  robot.radius = 2.0;
  const Neighbor small{.position = {2.0 + 0.5 + 0.05 * 2.5, 0.0}};
  EXPECT_NEAR(push(robot, small), 0.25 * equal, 1e-12);
}

// Beside others for four times the time in which it reaches its speed; it then gives way, but does
// not go back, until it is alone.
TEST(GiveWay, who_has_settled_stays_where_it_is_pushed_to) {
  PlannerOptions options;
  options.method = Method::avo;
  options.arrival_distance = 0.5;
  const Robot robot = at_distance(0.4);
  const Vec2 home{0.3, 0.0};
  const Traffic alone, resting{0.0, true, {}}, pushed{0.0, true, {-0.5, 0.0}};
  Detour detour;
  const double time = robot.max_speed / robot.max_acceleration;
  const auto wish_after = [&](double seconds, const Traffic& traffic) {
    Vec2 wish;
    for (double t = 0.0; t < seconds; t += options.time_step)
      wish = wish_of(robot, home, traffic, options, detour);
    return wish;
  };
  EXPECT_EQ(wish_after(3.9 * time, resting), home);
  EXPECT_EQ(wish_after(0.2 * time, resting), Vec2{});
  EXPECT_LT(wish_after(0.1, pushed).x, -1.0);
  EXPECT_EQ(wish_after(0.1, resting), Vec2{});
  EXPECT_EQ(wish_of(at_distance(0.46), home, resting, options, detour), home);
  EXPECT_EQ(wish_after(0.5 * time, alone), home);  // nobody is in its way
  EXPECT_GT(detour.settled, 0.9);
  EXPECT_EQ(wish_after(9.8 * time, alone), home);
  EXPECT_EQ(detour.settled, 0.0);
}

}  // namespace
}  // namespace avo
