// SPDX-License-Identifier: Apache-2.0
// Which options of a planner are refused, and how that is said.
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "avo/error.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::kInfinity;
using test::kNaN;

void expect_refused(const PlannerOptions& options, const std::string& field) {
  try {
    const Planner planner(options);
    FAIL() << field << " was accepted";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("PlannerOptions." + field), std::string::npos) << what;
    EXPECT_NE(what.find("must be"), std::string::npos) << what;
  }
}

TEST(Options, out_of_range_are_refused_by_name) {
  for (const double bad : {0.0, -0.0, -1.0, kNaN, kInfinity, -kInfinity}) {
    PlannerOptions options = test::paper_options();
    options.control_time = bad;
    expect_refused(options, "control_time");
    options = test::paper_options();
    options.time_horizon = bad;
    expect_refused(options, "time_horizon");
    options = test::paper_options();
    options.time_step = bad;
    expect_refused(options, "time_step");
  }
  PlannerOptions coarse = test::paper_options();
  coarse.time_step = 4.1;
  expect_refused(coarse, "time_step");
  coarse.motion = Motion::exponential;
  EXPECT_NO_THROW(Planner{coarse});
}

TEST(Options, follow_the_row_of_their_method) {
  struct Row {
    Method method;
    bool at_once, within_step, regardless, outside;
  };
  constexpr Row kRows[] = {{Method::avo, false, false, false, false},
                           {Method::avo_paper, false, false, false, false},
                           {Method::velocity_obstacle, true, false, true, true},
                           {Method::orca, true, false, true, false},
                           {Method::orca_clamped, false, true, true, false},
                           {Method::reciprocal_velocity_obstacle, true, false, true, true},
                           {Method::buffered_voronoi, false, true, false, false},
                           {Method::external, true, false, true, false},
                           {Method::external_clamped, false, true, true, false}};
  static_assert(std::size(kRows) == kMethodTraits.size());
  for (const Row& row : kRows) {
    const PlannerOptions options = default_options(row.method);
    const bool is_avo = row.method == Method::avo;
    EXPECT_EQ(adopts_at_once(row.method), row.at_once) << to_string(row.method);
    EXPECT_EQ(reaches_within_step(row.method), row.within_step) << to_string(row.method);
    EXPECT_EQ(disregards_acceleration(row.method), row.regardless) << to_string(row.method);
    EXPECT_EQ(avoids_union(row.method), row.outside) << to_string(row.method);
    EXPECT_EQ(may_be_certified(row.method), is_avo || row.within_step) << to_string(row.method);
    EXPECT_EQ(options.control_time, is_avo ? 2.0 : 4.0);
    EXPECT_EQ(options.time_horizon, is_avo ? 3.0 : 10.0);
    EXPECT_EQ(options.response_time, is_avo ? 0.1 : 0.0);
    EXPECT_EQ(options.certificate, is_avo ? Certificate::braking_trajectories : Certificate::none);
  }
}

TEST(Options, a_free_clock_is_refused_where_its_rule_does_not_hold) {
  PlannerOptions options;
  options.longest_step = 0.1;
  expect_refused(options, "longest_step");
  options.clock = Clock::free;
  EXPECT_NO_THROW(Planner{options});
  options.longest_step = kNaN;
  expect_refused(options, "longest_step");
  options.longest_step = -0.1;
  expect_refused(options, "longest_step");
  options.longest_step = 0.0;
  EXPECT_NO_THROW(Planner{options});
  options.motion = Motion::exponential;
  expect_refused(options, "clock");
  options.motion = Motion::held;
}

TEST(Options, times_of_which_rounding_would_exceed_the_limits_are_refused) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    PlannerOptions options = default_options(method);
    options.motion = Motion::exponential;
    for (const double bad : {5e-324, 1e-300, 1e-12, 1e-7, 1e-4}) {
      options.control_time = bad;
      expect_refused(options, "control_time");
    }
    // at the edge of what is accepted limits are kept
    options.control_time = options.time_step / 700.0 * (1.0 + 1e-15);
    const Planner planner(options);
    PlanWorkspace workspace;
    const Robot robot{.velocity = {1.0, 0.7}, .preferred_velocity = {-2.0, 0.3}};
    const Plan plan = planner.plan(robot, {}, workspace);
    EXPECT_TRUE(is_finite(plan.acceleration));
    EXPECT_LE(norm(plan.acceleration), robot.max_acceleration * (1.0 + 1e-9));
    options = default_options(method);
    options.control_time = options.time_step = 1e-7;
    expect_refused(options, "control_time");
    options = default_options(method);
    options.time_step = options.control_time = 1.01 * options.time_horizon;
    expect_refused(options, "time_step");
    options = default_options(method);
    options.time_horizon = 1.1e12;
    expect_refused(options, "time_horizon");
  }
  PlannerOptions at_once = default_options(Method::orca);
  at_once.control_time = 1e-12;  // has none
  EXPECT_NO_THROW(Planner{at_once});
}

// Each option that is left out is that of the method.
TEST(Options, that_are_left_out_follow_the_method) {
  for (const Method method :
       {Method::avo, Method::avo_paper, Method::velocity_obstacle, Method::orca,
        Method::orca_clamped, Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    const PlannerOptions usual = default_options(method);
    const PlannerOptions options = {.method = method};
    EXPECT_EQ(options.control_time, usual.control_time);
    EXPECT_EQ(options.time_horizon, usual.time_horizon);
    EXPECT_EQ(options.response_time, method == Method::avo ? 0.1 : 0.0);
    EXPECT_EQ(options.certificate, usual.certificate);
    const Planner planner(PlannerOptions{.method = method, .time_step = 0.2});
    EXPECT_EQ(planner.options().time_horizon, method == Method::avo ? 3.0 : 10.0);
    EXPECT_EQ(planner.options().certificate,
              method == Method::avo ? Certificate::braking_trajectories : Certificate::none);
  }
  const PlannerOptions set = {.method = Method::orca, .time_horizon = 5.0};
  EXPECT_EQ(set.time_horizon, 5.0);
}

std::string refusal(const PlannerOptions& options) {
  try {
    const Planner planner(options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Options, how_gently_robots_move_is_of_method_avo_alone) {
  for (const double bad : {-0.1, kNaN, kInfinity}) {
    PlannerOptions options;
    options.response_time = bad;
    expect_refused(options, "response_time");
    options = {};
    options.comfort_acceleration = bad;
    expect_refused(options, "comfort_acceleration");
    options = {};
    options.comfort_jerk = bad;
    expect_refused(options, "comfort_jerk");
    options = {};
    options.margin = bad;
    expect_refused(options, "margin");
  }
  for (const Method method :
       {Method::avo_paper, Method::velocity_obstacle, Method::orca, Method::orca_clamped,
        Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    PlannerOptions options = default_options(method);
    EXPECT_NO_THROW(Planner{options});
    options.response_time = 0.1;
    expect_refused(options, "response_time");
    options = default_options(method);
    options.comfort_acceleration = 0.5;
    expect_refused(options, "comfort_acceleration");
    options = default_options(method);
    options.comfort_jerk = 2.0;
    expect_refused(options, "comfort_jerk");
    options = default_options(method);
    options.margin = 0.1;
    expect_refused(options, "margin");
  }
}

TEST(Options, a_response_takes_two_steps_at_least) {
  PlannerOptions options;
  EXPECT_DOUBLE_EQ(response_time_of(options, 2.0, 0.5), 0.4);  // 0.1 of 4 s
  EXPECT_DOUBLE_EQ(response_time_of(options, 2.0, 4.0), 0.2);  // 0.05 s are less than two steps
  options.comfort_jerk = 2.5;
  EXPECT_DOUBLE_EQ(response_time_of(options, 2.0, 4.0), 2.0);  // 4 m/s² after 1.6 s
  options.comfort_acceleration = 0.5;
  EXPECT_DOUBLE_EQ(response_time_of(options, 2.0, 4.0), 0.25);
  options = {};
  options.response_time = 0.0;
  EXPECT_EQ(response_time_of(options, 2.0, 0.5), 0.0);
  EXPECT_EQ(response_time_of(default_options(Method::orca), 2.0, 0.5), 0.0);
}

TEST(Options, that_do_not_go_together_are_refused_by_name) {
  PlannerOptions options;
  for (const Method method :
       {Method::avo_paper, Method::velocity_obstacle, Method::orca, Method::orca_clamped,
        Method::reciprocal_velocity_obstacle, Method::buffered_voronoi, Method::external,
        Method::external_clamped}) {
    options = default_options(method);
    EXPECT_EQ(refusal(options), "");
    options.certificate = Certificate::braking_trajectories;
    EXPECT_EQ(refusal(options),
              may_be_certified(method)
                  ? ""
                  : std::string("PlannerOptions.certificate: found braking_trajectories, "
                                "must be none with method ") +
                        to_string(method));
  }
  options = {};
  options.max_neighbors = 0;
  EXPECT_EQ(refusal(options), "PlannerOptions.max_neighbors: found 0, must be >= 1");
  options = {};
  options.sensing_error = {.position = -0.01, .velocity = 0.0};
  EXPECT_EQ(refusal(options), "PlannerOptions.sensing_error.position: found -0.01, must be >= 0 m");
  options.sensing_error = {.position = 0.0, .velocity = std::nan("")};
  EXPECT_EQ(refusal(options),
            "PlannerOptions.sensing_error.velocity: found nan, must be a finite number");
  options.certificate = Certificate::none;
  options.sensing_error = {.position = 0.01, .velocity = 0.0};
  EXPECT_EQ(refusal(options),
            "PlannerOptions.sensing_error: found one, must be none with certificate none");
  options = {};
  options.arrival_distance = 0.0;
  EXPECT_EQ(refusal(options), "PlannerOptions.arrival_distance: found 0, must be > 0 m");
}

}  // namespace
}  // namespace avo
