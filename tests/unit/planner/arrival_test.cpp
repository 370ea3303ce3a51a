// SPDX-License-Identifier: Apache-2.0
// A robot makes room for some neighbors (docs/arrival.md, rule 2). These tests check for which ones
// it does so, and where it stays.
#include "planner/rules/arrival.h"

#include <cmath>
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

// As far as it moves.
double push(const Robot& robot, const Neighbor& neighbor) {
  const Vec2 push = motion_of(robot, neighbor) * push_of(robot, neighbor);
  EXPECT_LE(push.x, 0.0);
  EXPECT_EQ(push.y, 0.0);
  return -push.x;
}

// Step by step; the mean of the last hundred v_max/a_max.
TEST(KeepRight, as_far_as_the_way_is_more_congested_than_usual) {
  Detour detour;
  const auto after = [&](double time, double ahead) {
    double unusual = 0.0;
    for (double t = 0.0; t < time; t += 0.1) unusual = unusual_congestion(ahead, 2.0, 0.1, detour);
    return unusual;
  };
  EXPECT_NEAR(after(0.1, 1.0), 1.0, 2e-3);
  EXPECT_NEAR(after(100.0, 1.0), 1.0 - 2.0 * (1.0 - std::exp(-0.5)), 1e-2);
  EXPECT_EQ(after(100.0, 1.0), 0.0) << "it does not turn to the left";
  EXPECT_NEAR(detour.congestion, 1.0 - std::exp(-1.0), 1e-2);
  EXPECT_NEAR(after(0.1, 2.0), 2.0 - 2.0 * (1.0 - std::exp(-1.0)), 1e-2);
  after(5000.0, 50.0);
  EXPECT_TRUE(is_sound(detour)) << detour.congestion;
  for (float Detour::*number : {&Detour::acceleration_x, &Detour::acceleration_y}) {
    Detour broken = detour;
    broken.*number = std::nanf("");
    EXPECT_FALSE(is_sound(broken));
  }
  after(2000.0, 0.0);
  EXPECT_NEAR(detour.congestion, 0.0, 1e-3);
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

TEST(GiveWay, on_its_way_less_and_to_those_at_rest_as_well) {
  const double near = push(at_distance(0.0), beside({0.0, 1.0}));
  EXPECT_NEAR(push(at_distance(50.0), beside({})), 0.3 * near, 1e-12);
}

// It is the velocity relative to the neighbor that counts, near the goal not at all.
TEST(GiveWay, on_its_way_not_to_those_that_pass_by) {
  Robot robot = at_distance(50.0);
  const double full = push(robot, beside({}));
  robot.velocity = {0.0, 0.5};
  EXPECT_DOUBLE_EQ(push(robot, beside({0.0, 0.5})), full) << "side by side";
  EXPECT_NEAR(push(robot, beside({0.0, 0.5 + 0.5 * robot.max_speed})), 0.5 * full, 1e-12);
  EXPECT_EQ(push(robot, beside({0.0, 0.5 - robot.max_speed})), 0.0);
  EXPECT_EQ(push(robot, beside({0.0, -2.0})), 0.0);
  const Robot at_goal = at_distance(0.0);
  EXPECT_EQ(push(at_goal, beside({0.0, 1.0})), push(at_goal, beside({0.0, -2.0})));
  // the more of both counts: radii of 0.5 m, and 6 (r_A + r_B) before the goal it begins to grow
  const double at_once = push(at_goal, beside({0.0, -2.0}));
  EXPECT_NEAR(push(at_distance(5.0), beside({0.0, -2.0})), at_once / 6.0, 1e-12);
  EXPECT_NEAR(push(at_distance(5.0), beside({0.0, 0.4})), 0.8 * 0.3 * at_once, 1e-12);
}

TEST(GiveWay, to_smaller_ones_less) {
  Robot robot = at_distance(50.0);
  const double equal = push(robot, beside({}));
  robot.radius = 2.0;
  const Neighbor small{.position = {2.0 + 0.5 + 0.05 * 2.5, 0.0}};
  EXPECT_NEAR(push(robot, small), 0.25 * equal, 1e-12);
}

// What one that stays beside the same others wishes for, step by step; times in v_max/a_max.
struct Waiting {
  Robot robot;
  PlannerOptions options = {.method = Method::avo, .arrival_distance = 0.5};
  Vec2 home = {0.3, 0.0};
  Detour detour = {};

  Vec2 wish_after(double time, const Traffic& traffic) {
    const double step = options.time_step * robot.max_acceleration / robot.max_speed;
    Vec2 wish;
    for (double t = 0.5 * step; t < time; t += step)
      wish = wish_of(robot, home, traffic, push_rule(robot, traffic.is_beside, options, detour));
    return wish;
  }
};

const Traffic kAlone, kBesideOne{0.0, true, {}, {}}, kPushed{0.0, true, {-0.5, 0.0}, {}};
const Traffic kBesideOneAtRest{0.0, true, {}, {-0.5, 0.0}};

// A robot that is beside others for twice the time in which it reaches its speed makes room. It
// does not go back until it is alone.
TEST(GiveWay, who_has_settled_stays_where_it_is_pushed_to) {
  Waiting waiting{at_distance(0.4)};
  EXPECT_EQ(waiting.wish_after(1.9, kBesideOne), waiting.home);
  EXPECT_EQ(waiting.wish_after(0.2, kBesideOne), Vec2{});
  EXPECT_LT(waiting.wish_after(0.05, kPushed).x, -1.0);
  EXPECT_EQ(waiting.wish_after(0.05, kBesideOneAtRest), Vec2{});
  EXPECT_EQ(waiting.wish_after(1.5, kAlone), waiting.home);  // no robot hinders it
  EXPECT_GT(waiting.detour.beside, 1.5F);
  EXPECT_EQ(waiting.wish_after(10.0, kAlone), waiting.home);
  EXPECT_EQ(waiting.detour.beside, 0.0F);
}

// The robot loosens the crowd around it, and then tries to get in.
TEST(GiveWay, on_the_last_of_its_way_to_those_at_rest_by_turns) {
  Waiting waiting{at_distance(0.6)};
  EXPECT_NEAR(waiting.wish_after(12.5, kBesideOneAtRest).x,
              waiting.home.x - 5.0 * 0.5 * waiting.robot.max_speed, 1e-12);
  EXPECT_EQ(waiting.wish_after(0.2, kBesideOneAtRest), waiting.home);
  EXPECT_EQ(waiting.wish_after(1.2, kBesideOneAtRest), waiting.home);
  EXPECT_LT(waiting.wish_after(0.2, kBesideOneAtRest).x, 0.0);
  Waiting at_goal{at_distance(0.44)};
  EXPECT_EQ(at_goal.wish_after(1.9, kBesideOneAtRest), at_goal.home);
}

// However long it has been there: what it remembers has an end, and trying has none.
TEST(GiveWay, goes_on_by_turns_for_ever) {
  Waiting waiting{at_distance(0.6)};
  waiting.wish_after(1000.0, kBesideOneAtRest);
  int home = 0, away = 0;
  for (int i = 0; i < 140; ++i)
    ++(waiting.wish_after(0.1, kBesideOneAtRest) == waiting.home ? home : away);
  EXPECT_NEAR(home, 14, 1);
  EXPECT_NEAR(away, 126, 1);
}

// A robot that cannot get back to where it has been comes to rest farther and farther away.
TEST(GiveWay, who_has_been_at_its_goal_settles_beside_it_in_the_end) {
  for (const bool has_arrived : {true, false}) {
    Waiting waiting{at_distance(0.9)};
    waiting.detour.has_arrived = has_arrived;
    EXPECT_NE(waiting.wish_after(11.8, kBesideOne), Vec2{});
    EXPECT_EQ(waiting.wish_after(0.4, kBesideOne) == Vec2{}, has_arrived);
    waiting.robot.distance_to_goal = 1.96;
    EXPECT_NE(waiting.wish_after(170.0, kBesideOne), Vec2{}) << "no farther than that";
    waiting.robot.distance_to_goal = 10.1;  // it is sent elsewhere
    waiting.wish_after(0.05, kBesideOne);
    EXPECT_FALSE(waiting.detour.has_arrived);
  }
}

// By radii, where those are more than arrival distances.
TEST(GiveWay, who_has_been_at_its_goal_settles_however_small_the_arrival_distance_is) {
  Waiting waiting{at_distance(0.5)};
  waiting.options.arrival_distance = 0.05;
  waiting.detour.has_arrived = true;
  EXPECT_NE(waiting.wish_after(11.8, kBesideOne), Vec2{});
  EXPECT_EQ(waiting.wish_after(1.0, kBesideOne), Vec2{});
  waiting.robot.distance_to_goal = 1.56;
  EXPECT_NE(waiting.wish_after(170.0, kBesideOne), Vec2{}) << "no farther than that";
}

// Among robots at rest on its goal a robot goes where it prefers to, and to no robot's right.
TEST(GiveWay, nobody_does_who_comes_to_rest_among_others) {
  const Planner planner({.method = Method::avo});
  Robot robot;
  robot.preferred_velocity = {0.2, 0.0}, robot.distance_to_goal = 0.8;
  const std::vector<Neighbor> comes = {{.position = {0.0, 1.06}, .velocity = {0.0, -0.1}}};
  PlanWorkspace workspace;
  Detour usual{.beside = 1.0F}, taken{.beside = 1.0F, .goal_taken = true};
  const Plan pushed = planner.plan(robot, comes, workspace, &usual);
  const Plan kept = planner.plan(robot, comes, workspace, &taken);
  EXPECT_LT(pushed.next_velocity.y, kept.next_velocity.y - 0.001);
  EXPECT_TRUE(taken.goal_taken);
  EXPECT_EQ(taken.beside, 0.0F);
}

TEST(GiveWay, whoever_is_at_its_goal_remembers_that_it_has_been_there) {
  Waiting waiting{at_distance(0.51)};
  waiting.wish_after(1.0, kBesideOne);
  EXPECT_FALSE(waiting.detour.has_arrived);
  waiting.robot.distance_to_goal = 0.5;
  waiting.wish_after(0.05, kBesideOne);
  waiting.robot.distance_to_goal = 9.9;
  waiting.wish_after(0.05, kBesideOne);
  EXPECT_TRUE(waiting.detour.has_arrived);
  waiting.wish_after(10.0, kAlone);
  EXPECT_FALSE(waiting.detour.has_arrived) << "nobody was in its way for long";
}

}  // namespace
}  // namespace avo
