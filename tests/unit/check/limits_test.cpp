// SPDX-License-Identifier: Apache-2.0
// Limits on acceleration and speed, positions that do not follow the velocities, arrivals.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "unit/check/recordings.h"

namespace avo {
namespace {

using test::free_robot;
using test::Moment;
using test::report_of;

const std::vector<CheckedRobot> kOne{{}};  // 1 m/s^2, 2 m/s

// One robot from `start`, held accelerations of 0.1 s each.
std::vector<Moment> driven(const std::vector<Vec2>& accelerations, Vec2 start = {},
                           double begin = 0.0) {
  constexpr double kStep = 0.1;
  std::vector<Moment> recording{{begin, {{0, start, {}}}}};
  for (std::size_t k = 0; k < accelerations.size(); ++k) {
    CheckedState state = recording.back().rows[0];
    state.position =
        state.position + kStep * state.velocity + (0.5 * kStep * kStep) * accelerations[k];
    state.velocity = state.velocity + kStep * accelerations[k];
    recording.push_back({begin + static_cast<double>(k + 1) * kStep, {state}});
  }
  return recording;
}

TEST(CheckLimits, an_acceleration_spike_counts_once) {
  const CheckReport report = report_of(kOne, driven({{1, 0}, {-1, 0}, {1.5, 0}, {0, 1}, {0, 0}}));
  EXPECT_EQ(report.accelerations.count, 1);
  EXPECT_NEAR(report.accelerations.first->time, 0.2, 1e-12) << "where its step began";
  EXPECT_EQ(report.accelerations.first->robot, 0);
  EXPECT_EQ(report.accelerations.first->other, std::nullopt);
  EXPECT_NEAR(report.accelerations.first->amount, 0.5, 1e-12);
  EXPECT_NEAR(report.largest_acceleration, 1.5, 1e-12);
  EXPECT_FALSE(report.safe());
}

TEST(CheckLimits, the_length_of_the_acceleration_counts) {
  EXPECT_EQ(report_of(kOne, driven({{0.6, 0.8}, {-0.8, 0.6}})).accelerations.count, 0);
  EXPECT_EQ(report_of(kOne, driven({{0.8, 0.8}, {-0.8, 0.8}})).accelerations.count, 2);
}

TEST(CheckLimits, the_tolerance_is_relative) {
  EXPECT_TRUE(report_of(kOne, driven({{1.0 + 0.9e-9, 0}})).safe());
  EXPECT_FALSE(report_of(kOne, driven({{1.0 + 1.2e-9, 0}})).safe());
  EXPECT_TRUE(report_of(kOne, driven({{1.009, 0}}), {}, {.relative_tolerance = 0.01}).safe());
  EXPECT_FALSE(report_of(kOne, driven({{1.011, 0}}), {}, {.relative_tolerance = 0.01}).safe());
}

// 0.1 s between times of 1e7 s is wrong by 1e-8 of itself: rounding is granted.
TEST(CheckLimits, late_times_break_no_limit) {
  const std::vector<Vec2> braking(15, Vec2{-0.6, 0.8});
  EXPECT_TRUE(report_of(kOne, driven(braking, {1e6, -1e6}, 1e7)).safe());
  EXPECT_FALSE(report_of(kOne, driven({{1.001, 0}}, {1e6, -1e6}, 1e7)).safe());
}

TEST(CheckLimits, speeds_of_rows) {
  const auto at = [](Vec2 v) {
    return report_of(kOne, {{0.0, {{0, {0, 0}, v}}}, {1.0, {{0, v, v}}}});
  };
  EXPECT_EQ(at({1.2, 1.6}).speeds.count, 0);
  const CheckReport report = at({1.5, 1.5});
  EXPECT_EQ(report.speeds.count, 2) << "both rows";
  EXPECT_EQ(report.speeds.first->time, 0.0);
  EXPECT_NEAR(report.speeds.worst, std::sqrt(4.5) - 2.0, 1e-15);
  EXPECT_NEAR(report.largest_speed, std::sqrt(4.5), 1e-15);
  EXPECT_FALSE(report.safe());
  EXPECT_EQ(at({2.0 * (1.0 + 0.9e-9), 0}).speeds.count, 0);
  EXPECT_EQ(at({2.0 * (1.0 + 1.1e-9), 0}).speeds.count, 2);
}

TEST(CheckLimits, each_robot_has_its_own) {
  std::vector<CheckedRobot> robots(2);
  robots[1].max_acceleration = 3.0;
  robots[1].max_speed = 5.0;
  const std::vector<Moment> recording{{0.0, {{0, {0, 0}, {1, 0}}, {1, {9, 0}, {3, 0}}}},
                                      {1.0, {{0, {2, 0}, {3, 0}}, {1, {13, 0}, {5, 0}}}}};
  const CheckReport report = report_of(robots, recording);
  EXPECT_EQ(report.accelerations.count, 1);
  EXPECT_EQ(report.accelerations.first->robot, 0);
  EXPECT_EQ(report.speeds.count, 1);
  EXPECT_EQ(report.speeds.first->robot, 0);
  EXPECT_EQ(report.speeds.first->time, 1.0);
}

TEST(CheckLimits, infinite_limits_hold_always) {
  const CheckReport report =
      report_of({free_robot()}, {{0.0, {{0, {0, 0}, {0, 0}}}}, {1.0, {{0, {1e6, 0}, {-1e9, 0}}}}});
  EXPECT_TRUE(report.safe());
  EXPECT_EQ(report.largest_acceleration, 1e9);
  EXPECT_EQ(report.largest_speed, 1e9);
}

TEST(CheckLimits, positions_that_do_not_follow_the_velocities_are_jumps) {
  const auto moved = [](Vec2 way) {
    return report_of(kOne, {{0.0, {{0, {5, 5}, {}}}}, {0.1, {{0, Vec2{5, 5} + way, {}}}}});
  };
  EXPECT_EQ(moved({0, 0.00499}).jumps.count, 0) << "a_max Δt²/2 = 0.005 m";
  const CheckReport report = moved({0, 0.00501});
  EXPECT_EQ(report.jumps.count, 1);
  EXPECT_EQ(report.jumps.first->time, 0.0);
  EXPECT_NEAR(report.jumps.first->amount, 0.00001, 1e-9);
  EXPECT_EQ(report.accelerations.count, 0);
  EXPECT_FALSE(report.safe());
}

// Whenever the velocity changes within the step, the path is between the paths of both velocities.
TEST(CheckLimits, a_jump_without_a_limit_is_what_velocities_do_not_explain) {
  CheckedRobot robot = free_robot();
  const auto jumps = [&robot](Vec2 way) {
    return report_of({robot},
                     {{0.0, {{0, {5, 5}, {0, 0}}}}, {0.5, {{0, Vec2{5, 5} + way, {2, 0}}}}})
        .jumps;
  };
  EXPECT_EQ(jumps({50, 0}).count, 0) << "nobody asks";
  robot.largest_jump = 0.1;
  for (const double way : {-0.0999, 0.0, 0.5, 1.0, 1.0999})
    EXPECT_EQ(jumps({way, 0}).count, 0) << way;
  EXPECT_EQ(jumps({-0.1001, 0}).count, 1);
  EXPECT_NEAR(jumps({1.2, 0}).first->amount, 0.1, 1e-9);
  EXPECT_EQ(jumps({0.5, 0.601}).count, 1) << "off to the side";
  robot.largest_jump = -1.0;
  EXPECT_THROW(jumps({0, 0}), Error);
}

// p + Δt v_1: the velocity changes at once, by a_max Δt.
TEST(CheckLimits, velocities_that_change_at_once_are_no_jumps) {
  std::vector<Moment> recording{{0.0, {{0, {3, 4}, {}}}}};
  for (int k = 1; k <= 20; ++k) {
    CheckedState state = recording.back().rows[0];
    state.velocity = state.velocity + (k % 2 == 0 ? -0.1 : 0.1) * Vec2{0.6, 0.8};
    state.position = state.position + 0.1 * state.velocity;
    recording.push_back({0.1 * k, {state}});
  }
  EXPECT_TRUE(report_of(kOne, recording).safe());
}

// The goals leave no room for all robots. A robot that rests in the crowd around the place has
// arrived.
TEST(CheckArrivals, are_beside_those_who_stand_on_the_goal) {
  const auto arrived_at = [](const std::vector<double>& places, double speed) {
    std::vector<CheckedRobot> robots(places.size(), free_robot(0.5));
    std::vector<CheckedState> rows;
    for (std::size_t k = 0; k < places.size(); ++k) {
      robots[k].goal = Vec2{0, 0};
      rows.push_back({static_cast<std::int64_t>(k), {places[k], 0}, {k == 0 ? 0.0 : speed, 0}});
    }
    return report_of(robots, {{0.0, rows}, {1.0, rows}}, {}, {.arrival_distance = 0.4}).arrived;
  };
  EXPECT_EQ(arrived_at({0.0, 1.1, 2.3, -1.9}, 0.0), 4);
  EXPECT_EQ(arrived_at({0.0, 1.1, 2.3, -1.9}, 0.1), 1) << "they move";
  EXPECT_EQ(arrived_at({0.0, 30.0}, 0.0), 1) << "nothing keeps it from coming nearer";
  EXPECT_EQ(arrived_at({0.0, 2.1, 3.2}, 0.0), 1) << "a robot gets through between the first two";
  EXPECT_EQ(arrived_at({1.1, 2.2}, 0.0), 0) << "nobody stands on the goal";
}

// Cars stand side by side with their discs, which are ahead of the axles.
TEST(CheckArrivals, of_cars_are_those_of_their_discs) {
  std::vector<CheckedRobot> robots(2, free_robot(0.5));
  robots[0].goal = robots[1].goal = Vec2{0, 0};
  robots[1].kinematics = CheckedCar{.body_offset = 0.5};
  const auto arrived = [&](double heading) {
    const std::vector<CheckedState> rows{{0, {0, 0}, {}},
                                         {1, {2.1, 0}, {}, CheckedHeading{heading, 0.0}}};
    return report_of(robots, {{0.0, rows}, {1.0, rows}}, {}, {.arrival_distance = 0.4}).arrived;
  };
  EXPECT_EQ(arrived(0.0), 1) << "a robot gets through between them";
  EXPECT_EQ(arrived(std::numbers::pi), 2);
}

TEST(CheckArrivals, are_counted_at_rows) {
  std::vector<CheckedRobot> robots(4, free_robot(0.01));
  robots[0].goal = robots[1].goal = robots[2].goal = Vec2{10, 0};
  const auto row = [](std::int64_t robot, double x) {
    return CheckedState{robot, {x, 0.1 * static_cast<double>(robot)}, {}};
  };
  const std::vector<Moment> recording{{0.0, {row(0, 0), row(1, 1), row(2, 10), row(3, 3)}},
                                      {1.0, {row(0, 9.7), row(1, 5), row(2, 10), row(3, 4)}},
                                      {2.0, {row(0, 12), row(1, 9), row(2, 10), row(3, 5)}}};
  const CheckReport report = report_of(robots, recording, {}, {.arrival_distance = 0.4});
  EXPECT_EQ(report.with_goal, 3);
  EXPECT_EQ(report.arrived, 2) << "0 passes by, 2 has always been there";
  EXPECT_EQ(report.at_goal_at_end, 1);
  EXPECT_EQ(report.not_arrived, std::vector<std::int64_t>{1});
  EXPECT_EQ(report.last_arrival, std::nullopt);
  const CheckReport near = report_of(robots, recording, {}, {.arrival_distance = 1.1});
  EXPECT_EQ(near.arrived, 3);
  EXPECT_EQ(near.last_arrival, 2.0);
  EXPECT_EQ(near.not_arrived, std::vector<std::int64_t>{});
}

TEST(CheckArrivals, whoever_stays_has_arrived_once) {
  std::vector<CheckedRobot> robots{free_robot()};
  robots[0].goal = Vec2{10, 0};
  std::vector<Moment> recording;
  for (const double time : {0.0, 1.0, 2.0, 3.0})
    recording.push_back({time, {{0, {time > 0.5 ? 10.0 : 0.0, 0}, {}}}});
  EXPECT_EQ(report_of(robots, recording).last_arrival, 1.0);
}

TEST(CheckArrivals, a_robot_that_is_never_there_has_not_arrived) {
  std::vector<CheckedRobot> robots(2, free_robot());
  robots[0].goal = robots[1].goal = Vec2{};
  const CheckReport report = report_of(robots, {{0.0, {{0, {}, {}}}}, {1.0, {{0, {}, {}}}}});
  EXPECT_EQ(report.robots, 1);
  EXPECT_EQ(report.not_arrived, std::vector<std::int64_t>{1});
  EXPECT_EQ(report.last_arrival, std::nullopt);
}

// Held to where it is: any motion counts.
TEST(Limits, a_parked_robot_that_moves) {
  CheckedRobot robot;
  robot.parked = true;
  Check still({robot}), pushed({robot}), rolls({robot});
  for (int k = 0; k < 3; ++k) {
    const CheckedState rests{0, {1, 2}, {}};
    still.add(0.1 * k, std::vector{rests});
    pushed.add(0.1 * k, std::vector<CheckedState>{{0, {1.0 + 0.001 * k, 2}, {}}});
    rolls.add(0.1 * k, std::vector<CheckedState>{{0, {1.0 + 0.01 * k, 2}, {0.1, 0}}});
  }
  EXPECT_TRUE(still.report().safe());
  EXPECT_EQ(pushed.report().jumps.count, 2);
  EXPECT_EQ(rolls.report().speeds.count, 3);
}

}  // namespace
}  // namespace avo
