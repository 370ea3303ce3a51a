// SPDX-License-Identifier: Apache-2.0
// Settings that do not fit the robots are told with the arithmetic, those of the paper are not.
#include <chrono>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/scenario.h"

namespace avo_test {
namespace {

using avo::Scenario;
using Lines = std::vector<std::string>;

/// The paper's constants (§VI-A).
Scenario paper() {
  Scenario scenario;
  scenario.method = avo::Method::avo_paper;
  for (const double x : {-10.0, 10.0})
    scenario.robots.push_back({.position = {x, 0}, .velocity = {}, .goal = {-x, 0}});
  return scenario;
}

TEST(Advice, none_for_the_constants_of_the_paper) {
  EXPECT_EQ(avo::advice(paper()), Lines{});
  Scenario figures = paper();  // Figs. 3 to 6
  figures.control_time = 2.0;
  figures.time_horizon = 4.0;
  EXPECT_EQ(avo::advice(figures), Lines{});
  EXPECT_EQ(avo::advice(Scenario{}), Lines{}) << "no robots, nothing to advise on";
}

TEST(Advice, control_time_of_less_than_half_the_rule) {
  Scenario scenario = paper();
  scenario.control_time = 1.5;
  EXPECT_EQ(avo::advice(scenario),
            Lines{"control_time 1.5 s is less than half of 2 max_speed / max_acceleration = 2 * 2 "
                  "/ 1 = 4 s of robot 0: a decision changes its velocity by at most 1.5 * 1 = 1.5 "
                  "m/s"});
  scenario.method = avo::Method::orca;  // has no δ
  EXPECT_EQ(avo::advice(scenario), Lines{});
}

TEST(Advice, control_time_of_more_than_twice_the_rule) {
  Scenario scenario = paper();
  scenario.control_time = 8.0;
  EXPECT_EQ(avo::advice(scenario), Lines{});
  scenario.robots[1].max_acceleration = 1.25;
  EXPECT_EQ(avo::advice(scenario),
            Lines{"control_time 8 s is more than twice 2 max_speed / max_acceleration = 2 * 2 / "
                  "1.25 = 3.2 s of robot 1: it responds slowly"});
}

TEST(Advice, time_step_of_more_than_half_of_control_time) {
  Scenario scenario = paper();
  for (auto& robot : scenario.robots) robot.max_acceleration = 10.0;
  scenario.control_time = 0.4;
  scenario.time_step = 0.2;
  EXPECT_EQ(avo::advice(scenario), Lines{});
  scenario.time_step = 0.25;
  EXPECT_EQ(avo::advice(scenario),
            Lines{"time_step 0.25 s is more than half of control_time = 0.4 s: the control is "
                  "coarse"});
}

TEST(Advice, control_time_is_nothing_to_a_method_that_approaches_as_fast_as_it_can) {
  Scenario scenario = paper();
  scenario.method = avo::Method::avo;
  for (const double delta : {0.1, 1.5, 9.0}) {
    scenario.control_time = delta;
    EXPECT_EQ(avo::advice(scenario), Lines{});
  }
  scenario.control_time.reset();
  EXPECT_EQ(avo::advice(scenario), Lines{});
}

TEST(Advice, time_step_in_which_a_robot_passes_its_own_radius) {
  Scenario scenario = paper();
  scenario.robots[1].radius = 0.15;
  EXPECT_EQ(avo::advice(scenario),
            Lines{"time_step 0.1 s lets robot 1 travel 2 * 0.1 = 0.2 m between decisions, more "
                  "than its radius = 0.15 m"});
}

TEST(Advice, time_horizon_shorter_than_stopping) {
  Scenario scenario = paper();
  scenario.time_horizon = 2.0;
  EXPECT_EQ(avo::advice(scenario), Lines{});
  scenario.time_horizon = 1.5;
  EXPECT_EQ(avo::advice(scenario),
            Lines{"time_horizon 1.5 s is shorter than robot 0 needs to stop, max_speed / "
                  "max_acceleration = 2 / 1 = 2 s"});
}

TEST(Advice, sensing_radius_shorter_than_two_stopping_distances) {
  Scenario scenario = paper();
  scenario.sensing_radius = 5.41;
  EXPECT_EQ(avo::advice(scenario), Lines{});
  scenario.sensing_radius = 5.0;
  EXPECT_EQ(avo::advice(scenario),
            Lines{"sensing_radius 5 m is less than robot 0 and robot 1 need to keep clear of each "
                  "other, radius + max_speed * time_step + max_speed^2 / (2 max_acceleration) = "
                  "2.7 + 2.7 = 5.4 m"});
}

/// `side` x `side` robots 1.2 m apart.
Scenario crowd(int side, double sensing_radius) {
  Scenario scenario;
  scenario.time_step = 1.0 / 60.0;
  scenario.sensing_radius = sensing_radius;
  for (int k = 0; k < side * side; ++k) {
    const avo::Vec2 place{1.2 * (k % side), 1.2 * (k / side)};
    avo::RobotSetup robot;
    robot.position = place, robot.goal = place, robot.radius = 0.3;
    robot.max_speed = robot.preferred_speed = 1.3;
    scenario.robots.push_back(robot);
  }
  return scenario;
}

TEST(Advice, sensing_radius_that_costs_many_times_what_is_needed) {
  Scenario scenario = crowd(45, 12.0);
  EXPECT_EQ(avo::advice(scenario),
            Lines{"sensing_radius 12 m is 2.6 times the 4.6279 m that the robots need: a robot "
                  "senses 257 others at the start instead of 41, so that a step costs about 6.2 "
                  "times as much; leave sensing_radius out, or set max_neighbors"});
  scenario.max_neighbors = 10;
  EXPECT_EQ(avo::advice(scenario), Lines{});
  EXPECT_EQ(avo::advice(crowd(45, 4.0)), Lines{});  // 2.6 times
  EXPECT_EQ(avo::advice(crowd(6, 12.0)), Lines{});  // of few
  scenario = crowd(45, 12.0);
  scenario.sensing_radius.reset();
  EXPECT_EQ(avo::advice(scenario), Lines{});
}

TEST(Advice, localization_that_may_leave_no_way_out_of_a_corner) {
  Scenario scenario = paper();
  scenario.method = avo::Method::avo;
  scenario.robots[1].radius = 0.4;
  scenario.sensing.localization = {.position = 0.2,
                                   .distribution = avo::NoiseDistribution::uniform};
  EXPECT_EQ(avo::advice(scenario), Lines{}) << "without walls";
  Scenario walled = scenario;
  walled.obstacles = {{.chains = {{{{-30.0, 8.0}, {30.0, 8.0}}}}}};
  const Lines told{
      "sensing.localization lets robot 1 be up to 0.282843 m off where it takes itself to be, and "
      "half of its radius is 0.2 m: it may stay in a corner"};
  EXPECT_EQ(avo::advice(walled), told);
  walled.sensing.localization.position = 0.141;  // 0.1994 m
  EXPECT_EQ(avo::advice(walled), Lines{});
  walled.sensing.localization.position = 0.142;  // 0.2008 m
  EXPECT_EQ(avo::advice(walled).size(), 1U);
  // a parked robot is a wall to the other robots, and it needs no route itself
  scenario.robots.push_back(
      {.position = {0, 9}, .goal = {0, 9}, .radius = 0.1, .behavior = avo::Behavior::parked});
  EXPECT_EQ(avo::advice(scenario), told);
}

TEST(Advice, speeds_beyond_max_speed) {
  Scenario scenario = paper();
  scenario.robots[0].preferred_speed = 3.0;
  scenario.robots[1].velocity = {0.0, -2.5};
  EXPECT_EQ(avo::advice(scenario),
            (Lines{"preferred_speed 3 m/s of robot 0 is more than its max_speed = 2 m/s",
                   "velocity of robot 1 is 2.5 m/s at the start, more than its max_speed = 2 m/s: "
                   "it brakes first"}));
}

/// Two that fly at 1 m/s to 2 m/s, with less acceleration than they would need to stop in time.
Scenario flight() {
  Scenario scenario = paper();
  scenario.method = avo::Method::avo;
  scenario.sensing_radius = 40.0;
  for (auto& robot : scenario.robots)
    robot.model = avo::Airplane{.min_speed = 1.0}, robot.max_acceleration = 0.1;
  return scenario;
}

TEST(Advice, airplanes_need_no_time_to_stop) {
  Scenario scenario = flight();
  EXPECT_EQ(avo::advice(scenario), Lines{});
  scenario.robots[1].model = avo::Holonomic{};
  ASSERT_EQ(avo::advice(scenario).size(), 1U);
  EXPECT_TRUE(
      avo::advice(scenario)[0].starts_with("time_horizon 3 s is shorter than robot 1 needs"));
  // but room to circle, by two diameters
  scenario = flight();
  scenario.certificate = avo::Certificate::none;
  scenario.sensing_radius = 17.4001;
  EXPECT_EQ(avo::advice(scenario), Lines{});
  scenario.sensing_radius = 17.0;
  EXPECT_EQ(avo::advice(scenario),
            Lines{"sensing_radius 17 m is less than robot 0 and robot 1 need to keep clear of each "
                  "other, radius + max_speed * time_step + 2 max_speed^2 / lateral_acceleration = "
                  "8.70001 + 8.70001 = 17.4 m"});
}

TEST(Advice, airplanes_that_are_told_to_fly_slower_than_they_can) {
  Scenario scenario = flight();
  scenario.robots[0].preferred_speed = 0.5;
  scenario.robots[1].preferred_speed = 0.0;
  EXPECT_EQ(
      avo::advice(scenario),
      (Lines{"preferred_speed 0 m/s of robot 1 is less than its min_speed = 1 m/s: it circles "
             "where it starts, for ever",
             "preferred_speed 0.5 m/s of robot 0 is less than its min_speed = 1 m/s, with "
             "which it flies"}));
}

TEST(Advice, overlaps_at_the_start_by_name) {
  Scenario scenario = paper();
  scenario.robots[1].position = {-9.25, 0.0};
  scenario.moving_obstacles.push_back(
      {.position = {-10.0, 1.0}, .velocity = {}, .acceleration = {}, .radius = 0.6});
  EXPECT_EQ(avo::advice(scenario),
            (Lines{"robot 0 and robot 1 overlap at the start: 0.75 m between the centers, "
                   "radii 0.5 + 0.5 = 1 m",
                   "robot 0 and moving obstacle 0 overlap at the start: 1 m between the centers, "
                   "radii 0.5 + 0.6 = 1.1 m"}));
  scenario.moving_obstacles.clear();
  scenario.robots[1].position = {-9.0, 0.0};
  EXPECT_EQ(avo::advice(scenario), Lines{}) << "touching is no overlap";
}

TEST(Advice, overlaps_are_found_wherever_the_pair_lies) {
  for (const bool upright : {false, true}) {
    Scenario scenario;
    scenario.method = avo::Method::avo_paper;
    for (int i = 0; i < 300; ++i) {
      const double along = 1.5 * i;
      const avo::Vec2 place = upright ? avo::Vec2{0.0, along} : avo::Vec2{along, 0.0};
      scenario.robots.push_back({.position = place, .velocity = {}, .goal = {}});
    }
    scenario.robots[40].position = scenario.robots[217].position + avo::Vec2{0.3, 0.4};
    const Lines lines = avo::advice(scenario);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].starts_with("robot 40 and robot 217 overlap at the start: 0.5 m"));
  }
}

TEST(Advice, a_heap_of_robots_takes_four_lines_and_little_time) {
  Scenario scenario;
  scenario.method = avo::Method::avo_paper;
  for (int i = 0; i < 20000; ++i)
    scenario.robots.push_back({.position = {1e-9 * i, 0}, .velocity = {}, .goal = {}});
  const Lines lines = avo::advice(scenario);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[3], "at least 997 further pairs overlap at the start");
}

TEST(Validate, held_motion_needs_a_time_step_within_control_time) {
  Scenario scenario = paper();
  scenario.control_time = 0.1;
  EXPECT_NO_THROW(avo::validate(scenario)) << "q = 1 - dt / delta = 0 is the limit";
  scenario.control_time = 0.09;
  EXPECT_THROW(avo::validate(scenario), avo::Error);
  scenario.motion = avo::Motion::exponential;
  EXPECT_NO_THROW(avo::validate(scenario));
  scenario.motion = avo::Motion::held;
  scenario.method = avo::Method::orca;
  EXPECT_NO_THROW(avo::validate(scenario));
}

TEST(LastStep, counts_decimal_fractions_as_they_are_meant) {
  Scenario scenario = paper();
  scenario.time_step = 0.1;
  EXPECT_EQ(avo::last_step(scenario, 0.0), 0);
  EXPECT_EQ(avo::last_step(scenario, 0.3), 3);
  EXPECT_EQ(avo::last_step(scenario, 0.29999), 2);
  EXPECT_EQ(avo::last_step(scenario, 60.0), 600);
  for (int k = 0; k < 100000; ++k)
    ASSERT_EQ(avo::last_step(scenario, k * scenario.time_step), k) << "as simulations count time";
  for (int k = 0; k < 1000; ++k)
    ASSERT_EQ(avo::last_step(scenario, std::stod(std::to_string(k) + "e-1")), k);
}

}  // namespace
}  // namespace avo_test
