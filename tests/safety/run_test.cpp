// SPDX-License-Identifier: Apache-2.0
// Runs are judged, measured and summarized as said; mistakes on the command line take one line.
#include "run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "alone_scenes.h"
#include "options.h"
#include "output.h"
#include "read_scene.h"
#include "table.h"
#include "wall_scenes.h"

namespace avo::safety {
namespace {

Scene two_robots(double gap, double duration) {
  Scene scene{usual_scenario()};
  scene.scenario.robots = {usual_robot({}, {0.0, 10.0}, 1.5),
                           usual_robot({1.0 + gap, 0.0}, {1.0 + gap, 10.0}, 1.5)};
  scene.unit = scene.scenario.duration = duration;
  return scene;
}

TEST(RunScene, notes_arrivals_and_ends_at_rest) {
  const Outcome outcome = run_scene(two_robots(3.0, 60.0), 1, "");
  EXPECT_TRUE(outcome.verdict.safe()) << outcome.verdict.violations;
  EXPECT_EQ(outcome.at_goal_at_end, 2);
  EXPECT_LT(outcome.robot_steps, 2 * 600);
  for (const double time : outcome.arrival) {
    EXPECT_GT(time, 9.5 / 1.5);
    EXPECT_LT(time, 20.0);
  }
  EXPECT_NEAR(*outcome.verdict.least_clearance, 3.0, 0.1);
  std::int64_t decisions = 0;
  for (const std::int64_t count : outcome.decisions) decisions += count;
  EXPECT_EQ(decisions, outcome.robot_steps);
}

TEST(RunScene, leaves_who_does_not_arrive_unarrived) {
  const Outcome outcome = run_scene(two_robots(3.0, 2.0), 1, "");
  EXPECT_EQ(outcome.arrival, (std::vector<double>{kNever, kNever}));
  EXPECT_EQ(outcome.at_goal_at_end, 0);
  EXPECT_EQ(outcome.robot_steps, 2 * 20);
}

// vx of the last robot after every step, from a recording.
std::vector<double> recorded_speeds(const Scene& scene) {
  const std::string path = testing::TempDir() + "recording.csv";
  run_scene(scene, 1, path);
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "time,robot,x,y,vx,vy");
  std::vector<double> speeds;
  while (std::getline(file, line)) {
    double time = 0.0, x = 0.0, y = 0.0, vx = 0.0;
    int robot = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%d,%lf,%lf,%lf", &time, &robot, &x, &y, &vx), 5);
    if (robot == 1) speeds.push_back(vx);
  }
  return speeds;
}

TEST(RunScene, sends_all_robots_to_one_point_after_the_other) {
  Scene scene = two_robots(3.0, 0.9);
  scene.unit = 0.0;
  scene.rally_period = 1.0;
  scene.rallies = {{-50.0, 0.0}};
  std::vector<double> speeds = recorded_speeds(scene);
  EXPECT_EQ(speeds.size(), 10U);
  EXPECT_LT(speeds.back(), -0.5);  // at once

  scene.rallies = {{-50.0, 0.0}, {50.0, 0.0}};
  scene.scenario.duration = 20.0;
  speeds = recorded_speeds(scene);
  EXPECT_EQ(speeds.size(), 201U);
  EXPECT_LT(*std::min_element(speeds.begin(), speeds.end()), -0.5);
  EXPECT_GT(*std::max_element(speeds.begin(), speeds.end()), 0.5);
}

TEST(RunScene, sends_robots_on_that_are_where_they_were_sent) {
  Scene scene = two_robots(3.0, 60.0);
  scene.unit = 0.0;
  scene.errands = {{{0.0, 3.0}, {0.0, 6.0}}, {{4.0, 8.0}}};
  const std::string path = testing::TempDir() + "errands.csv";
  run_scene(scene, 1, path);
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  int visits = 0, at = 0;  // of the first robot, to either place
  Vec2 last;               // of the second one
  while (std::getline(file, line)) {
    double time = 0.0, x = 0.0, y = 0.0;
    int robot = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%d,%lf,%lf", &time, &robot, &x, &y), 4);
    if (robot == 1) last = {x, y};
    const int here = y < 3.5 ? 1 : y > 5.5 ? 2 : at;
    if (robot == 0 && here != at) ++visits, at = here;
  }
  EXPECT_GE(visits, 5);
  EXPECT_LE(norm(last - Vec2{4.0, 8.0}), 0.5);  // that it has no other place to go to is no harm
}

Scene before_a_wall() {
  Scene scene = two_robots(3.0, 4.0);
  scene.scenario.obstacles = {{{Chain{{{-1.0, 3.0}, {1.0, 3.0}}}}}};  // of the first robot
  scene.scenario.navigation = false;
  return scene;
}

TEST(RunScene, nobody_arrives_behind_a_wall) {
  Scene scene = before_a_wall();
  scene.scenario.robots[0].goal = {0.0, 3.2};
  scene.scenario.robots[1].goal = {4.0, 3.2};
  scene.scenario.arrival_distance = 0.9;
  scene.scenario.duration = 10.0;  // the run ends before the robot finds a route
  const Outcome outcome = run_scene(scene, 1, "");
  EXPECT_TRUE(outcome.verdict.safe());
  EXPECT_EQ(outcome.arrival[0], kNever);
  EXPECT_LT(outcome.arrival[1], 10.0);
  EXPECT_EQ(outcome.at_goal_at_end, 1);
}

TEST(Judge, finds_who_touches_a_wall) {
  Scene scene = before_a_wall();
  Verdict verdict = run_scene(scene, 1, "").verdict;
  EXPECT_TRUE(verdict.safe()) << verdict.violations;
  EXPECT_GT(*verdict.least_static_clearance, 0.0);
  EXPECT_LT(*verdict.least_static_clearance, 0.5);

  scene.scenario.certificate = Certificate::none;
  scene.scenario.robots[0].velocity = {0.0, 2.0};  // too late to stop
  scene.scenario.robots[0].position = {0.0, 1.5};
  const Outcome outcome = run_scene(scene, 1, "");
  verdict = outcome.verdict;
  EXPECT_EQ(verdict.static_contacts, 1);
  EXPECT_FALSE(verdict.safe());
  EXPECT_NE(verdict.violations.find("touched a wall"), std::string::npos);
  EXPECT_EQ(*verdict.least_static_clearance, -0.5);  // it crosses the wall
  const RowResult row = summarize("row", {outcome});
  EXPECT_EQ(row.unsafe_scenes, 1);
  EXPECT_NE(table_lines(row).find("walls: touched by 1 robots, least clearance -500 mm"),
            std::string::npos)
      << table_lines(row);
}

TEST(Judge, finds_cars_no_nearer_to_walls_than_they_are) {
  // cubics through the ends of these cars' steps cut into walls, by 1e-6 m
  const Outcome outcome = run_scene(walls_and_cars(5e4, 1), 1, "");
  EXPECT_TRUE(outcome.verdict.safe()) << outcome.verdict.violations;
  EXPECT_GT(*outcome.verdict.least_static_clearance, 0.0);
  EXPECT_LT(*outcome.verdict.least_static_clearance, 1e-9);
}

TEST(Judge, finds_overlaps_and_broken_limits) {
  EXPECT_EQ(run_scene(two_robots(-0.01, 1.0), 1, "").verdict.overlapping_pairs, 1);
  Scene fast = two_robots(3.0, 1.0);
  fast.scenario.robots[0].velocity = {0.0, 2.1};  // v_max is 2
  EXPECT_GE(run_scene(fast, 1, "").verdict.speed_violations, 1);
  Scene abrupt = two_robots(3.0, 1.0);
  abrupt.scenario.method = Method::orca;
  EXPECT_GE(run_scene(abrupt, 1, "").verdict.acceleration_violations, 2);
}

TEST(Judge, tells_contacts_in_motion_from_those_at_rest) {
  Scene scene{usual_scenario()};
  scene.scenario.robots = {usual_robot({}, {}, 1.5)};
  scene.scenario.robots[0].max_acceleration = 1e-12;  // it stays where it is
  scene.scenario.certificate = Certificate::none;
  scene.scenario.moving_obstacles = {{{1.05, 0.0}, {-1.0, 0.0}, {}, 0.5}};
  scene.scenario.duration = 0.2;
  Verdict verdict = run_scene(scene, 1, "").verdict;
  EXPECT_EQ(verdict.resting_contacts, 1);
  EXPECT_EQ(verdict.moving_contacts, 0);
  EXPECT_TRUE(verdict.safe()) << verdict.violations;

  scene.scenario.robots[0].velocity = {1.0, 0.0};  // too late to stop
  scene.scenario.robots[0].max_acceleration = 1.0;
  scene.scenario.moving_obstacles[0].velocity = {};
  verdict = run_scene(scene, 1, "").verdict;
  EXPECT_EQ(verdict.resting_contacts, 0);
  EXPECT_EQ(verdict.moving_contacts, 1);
  EXPECT_FALSE(verdict.safe());
}

Outcome outcome_of(std::vector<double> arrival) {
  Outcome outcome;
  outcome.arrival = std::move(arrival);
  outcome.unit = 10.0;
  outcome.limit = 2.0;
  outcome.share = 0.99;
  outcome.robot_steps = 1000;
  outcome.seconds = 2e-3;
  return outcome;
}

TEST(Judge, finds_hits_that_were_evadable) {
  const Scene scene = alone_at_goal(9);
  EXPECT_TRUE(run_scene(scene, 1, "").verdict.safe());
  Scene hit = scene;
  hit.scenario.method = Method::orca_clamped;
  hit.scenario.certificate = Certificate::none;
  EXPECT_EQ(run_scene(hit, 1, "").verdict.evadable_hits, 1);
  EXPECT_FALSE(run_scene(hit, 1, "").verdict.safe());
  hit.alone = false;
  EXPECT_EQ(run_scene(hit, 1, "").verdict.evadable_hits, 0) << "nobody asks";
  Scene braking = scene;  // only, so it stays where it is
  braking.scenario.method = Method::avo_paper;
  braking.scenario.certificate = Certificate::none;
  braking.scenario.robots[0].preferred_speed = 0.0;
  braking.scenario.robots[0].max_acceleration = 1e-3;
  EXPECT_EQ(run_scene(braking, 1, "").verdict.evadable_hits, 0) << "it can do nothing else";
  Scene late = scene;
  late.scenario.moving_obstacles[0].radius = 4.0;
  late.alone = false;
  EXPECT_EQ(run_scene(late, 1, "").verdict.evadable_hits, 0) << "nobody asks";
}

// Strong robots have short braking, at goals that six to ten moving obstacles pass over. Some
// robots have nowhere to rest for ever. Some robots decide in so small steps that courses take long
// to search.
TEST(Alone, nobody_is_hit_who_could_have_kept_clear) {
  for (const std::uint64_t seed : {45, 267, 268, 429}) {
    const Outcome outcome = run_scene(alone_at_goal(seed), seed, "");
    EXPECT_TRUE(outcome.verdict.safe()) << seed << ": " << outcome.verdict.violations;
  }
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (auto* make : {alone_crossing, alone_over_road, alone_surprised, alone_among_paths}) {
      const Outcome outcome = run_scene(make(seed), seed, "");
      EXPECT_TRUE(outcome.verdict.safe()) << seed << ": " << outcome.verdict.violations;
    }
  }
}

TEST(Table, takes_the_99_percent_of_all_robots) {
  std::vector<double> arrival(99, 15.0);
  arrival.push_back(kNever);
  const RowResult row = summarize("row", {outcome_of(arrival)});
  EXPECT_EQ(row.arrived, 99);
  EXPECT_EQ(row.last, kNever);
  EXPECT_DOUBLE_EQ(row.late, 15.0);
  EXPECT_DOUBLE_EQ(row.late_ratio, 1.5);
  EXPECT_EQ(row.late_scenes, 0);
  EXPECT_DOUBLE_EQ(row.microseconds, 2.0);
  arrival[0] = 20.1;  // later than twice the unit
  EXPECT_EQ(summarize("row", {outcome_of(arrival)}).late_scenes, 1);
  EXPECT_DOUBLE_EQ(summarize("row", {outcome_of(arrival)}).late, 20.1);
}

TEST(Table, compares_the_scenes_of_a_row) {
  Outcome all = outcome_of({5.0, 7.0, 9.0}), some = outcome_of({5.0, kNever, kNever});
  Outcome most = outcome_of({5.0, 6.0, kNever});
  all.duration = some.duration = most.duration = 60.0;
  RowResult row = summarize("row", {all, some, most});
  EXPECT_EQ(row.full_scenes, 1);
  EXPECT_EQ(row.fewest_arrived, 1);
  EXPECT_EQ(row.median_last, 60.0);
  row = summarize("row", {all, some, all, outcome_of({11.0})});
  EXPECT_EQ(row.full_scenes, 3);
  EXPECT_NE(table_lines(row).find("all arrive in 3 of 4, the fewest in one are 1; median of the "
                                  "last arrivals 9.0 s"),
            std::string::npos)
      << table_lines(row);
}

TEST(Table, names_what_failed_and_how_to_repeat_it) {
  Outcome outcome = outcome_of({15.0, kNever});
  outcome.seed = 7;
  outcome.verdict.overlapping_pairs = 2;
  outcome.verdict.violations = "2 overlapping pairs";
  const RowResult row = summarize("row", {outcome, outcome_of({15.0})});
  EXPECT_EQ(row.unsafe_scenes, 1);
  EXPECT_EQ(failure_lines(row, {outcome, outcome_of({15.0})}, " --motion held"),
            "  seed 7: 2 overlapping pairs; 1 not arrived: 1; --row row --scenes 1 "
            "--first-seed 7 --motion held\n");
}

std::string refusal(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "avo_bench_safety");
  try {
    parse_options(static_cast<int>(arguments.size()), arguments.data());
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Options, are_refused_in_one_line) {
  EXPECT_EQ(refusal({"--scenes", "0"}),
            "--scenes: found \"0\", must be a whole number from 1 to 1000000");
  EXPECT_EQ(refusal({"--control-time", "1x"}),
            "--control-time: found \"1x\", must be a number of seconds from 1e-6 to 1e6");
  EXPECT_EQ(refusal({"--motion", "helt"}),
            "--motion: found \"helt\", must be one of held, exponential");
  EXPECT_EQ(refusal({"--row"}), "--row: found no value, or no such option; see --help");
  EXPECT_EQ(refusal({"--rows", "x"}), "--rows: found no such option; see --help");
  EXPECT_EQ(refusal({"--scenes", "7", "--method", "orca"}), "");
}

TEST(Options, rows_are_asked_for_by_name_or_beginning) {
  const std::vector<std::string> all{"circle-10", "circle-100", "swap"};
  Options options;
  options.rows = {"circle-10"};
  EXPECT_TRUE(is_asked_for(options, "circle-10", all));
  EXPECT_FALSE(is_asked_for(options, "circle-100", all));
  options.rows = {"circle"};
  EXPECT_TRUE(is_asked_for(options, "circle-100", all));
  EXPECT_FALSE(is_asked_for(options, "swap", all));
}

TEST(Options, leave_a_rows_own_times) {
  Options options;
  options.control_time = 0.7;
  options.time_horizon = 3.0;
  Scenario usual = usual_scenario();
  apply(options, usual);
  EXPECT_EQ(usual.control_time, 0.7);
  Scenario own = read_scene({"circle-10", {"control_time=2", "time_horizon=6"}}, 1);
  apply(options, own);
  EXPECT_EQ(own.control_time, 2.0);
  EXPECT_EQ(own.time_horizon, 6.0);
}

TEST(Output, is_whole_or_not_there) {
  const std::string path = testing::TempDir() + "output.txt";
  std::remove(path.c_str());
  {
    Output output(path);
    output.write("half");
  }
  EXPECT_FALSE(std::ifstream(path).is_open());
  Output output(path);
  output.write("whole");
  output.commit();
  std::string text;
  std::ifstream(path) >> text;
  EXPECT_EQ(text, "whole");
}

}  // namespace
}  // namespace avo::safety
