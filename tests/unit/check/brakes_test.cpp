// SPDX-License-Identifier: Apache-2.0
// Braking that is stronger than what a robot does otherwise: a step is full braking, what
// max_acceleration allows, or a mixture of both.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "unit/check/rules.h"

namespace avo::test {
namespace {

constexpr double kStrong = 3.0;  // m/s^2; a_max is 1

CheckedRobot strong(const CheckedKinematics& kinematics = {}) {
  CheckedRobot robot;
  robot.kinematics = kinematics;
  robot.max_braking = kStrong;
  return robot;
}

Moment moved(double time, Vec2 start, Vec2 velocity, Vec2 acceleration) {
  return {time,
          {{0, start + time * velocity + (0.5 * time * time) * acceleration,
            velocity + time * acceleration}}};
}

// The robot moves at 1.5 m/s in the direction of x.
std::int64_t broken_by(Vec2 acceleration, const CheckedRobot& robot = strong()) {
  const Vec2 v{1.5, 0.0};
  return report_of({robot}, {moved(0.0, {}, v, acceleration), moved(kStep, {}, v, acceleration)})
      .accelerations.count;
}

TEST(CheckBrakes, straight_braking_is_held_to_max_braking) {
  EXPECT_EQ(broken_by({-kStrong * kWithin, 0.0}), 0);
  EXPECT_EQ(broken_by({-kStrong * kBeyond, 0.0}), 1);
  CheckedRobot weak = strong();
  weak.max_braking = 0.5;  // which a decision may exceed
  EXPECT_EQ(broken_by({-kWithin, 0.0}, weak), 0);
  EXPECT_EQ(broken_by({-kBeyond, 0.0}, weak), 1);
}

TEST(CheckBrakes, speeding_up_and_turning_are_not) {
  for (const Vec2 direction : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{0.6, -0.8}}) {
    EXPECT_EQ(broken_by(kWithin * direction), 0);
    EXPECT_EQ(broken_by(kBeyond * direction), 1);
  }
}

// The edges of the hull lead from full braking to where they touch the disc.
TEST(CheckBrakes, a_part_of_braking_leaves_a_part_of_the_rest) {
  const double cosine = 1.0 / kStrong, sine = std::sqrt(1.0 - cosine * cosine);
  const Vec2 tip{-kStrong, 0.0}, touched{-cosine, sine};
  for (const double part : {0.0, 0.1, 0.5, 0.9}) {
    const Vec2 edge = part * tip + (1.0 - part) * touched;
    EXPECT_EQ(broken_by(kWithin * edge), 0) << part;
    EXPECT_EQ(broken_by(kBeyond * edge), 1) << part;
    EXPECT_EQ(broken_by({edge.x, -0.99 * edge.y}), 0) << part;
    EXPECT_EQ(broken_by({edge.x, -1.01 * edge.y}), 1) << part;
  }
}

TEST(CheckBrakes, nobody_brakes_beyond_rest) {
  const auto broken = [](double speed, double acceleration) {
    const Vec2 v{speed, 0.0}, a{acceleration, 0.0};
    return report_of({strong()}, {moved(0.0, {}, v, a), moved(kStep, {}, v, a)})
        .accelerations.count;
  };
  EXPECT_EQ(broken(0.2, -2.0), 0);
  EXPECT_EQ(broken(0.2, -2.1), 1);
  EXPECT_EQ(broken(0.0, -1.1), 1);
}

TEST(CheckBrakes, amounts_are_beyond_the_limit) {
  const Vec2 v{1.5, 0.0}, a{0.0, 1.25};
  const CheckReport report = report_of({strong()}, {moved(0.0, {}, v, a), moved(kStep, {}, v, a)});
  EXPECT_NEAR(report.accelerations.worst, 0.25, 1e-12);
  EXPECT_NEAR(report.largest_acceleration, 1.25, 1e-12);
}

// Rows within a step: the velocity has turned since it began.
TEST(CheckBrakes, rows_within_the_steps_of_its_own_clock_break_none) {
  const double cosine = 1.0 / kStrong, sine = std::sqrt(1.0 - cosine * cosine);
  const Vec2 edge = 0.5 * Vec2{-kStrong, 0.0} + 0.5 * Vec2{-cosine, sine}, v{1.5, 0.0};
  std::vector<Moment> rows;
  for (int k = 0; k <= 4; ++k) rows.push_back(moved(k * kStep, {}, v, kWithin * edge));
  CheckedRobot robot = strong();
  EXPECT_GT(report_of({robot}, rows).accelerations.count, 0) << "decided at each row";
  robot.time_step = 4.0 * kStep;
  EXPECT_FALSE(report_of({robot}, rows).broken());
  rows.clear();
  for (int k = 0; k <= 4; ++k) rows.push_back(moved(k * kStep, {}, v, {-1.0, 1.5}));
  EXPECT_GT(report_of({robot}, rows).accelerations.count, 0);
}

// Over missing rows the path is unknown: the check knows only how much can have changed.
TEST(CheckBrakes, over_missing_rows_the_length_counts) {
  const auto broken = [](Vec2 acceleration) {
    Check check({strong()});
    check.add(0.0, moved(0.0, {}, {1.5, 0.0}, {}).rows);
    check.skip();
    check.add(kStep, moved(kStep, {}, {1.5, 0.0}, acceleration).rows);
    return check.report().accelerations.count;
  };
  EXPECT_EQ(broken({0.0, 2.9}), 0);
  EXPECT_EQ(broken({0.0, 3.1}), 1);
}

// Held controls of a car at 1.5 m/s, forward or backwards: along its heading and across it.
std::vector<std::int64_t> counts_of(const CheckedCar& car, Vec2 pull) {
  const double sign = car.reverse ? -1.0 : 1.0, top = std::max(1.5, 1.5 + pull.x * kStep);
  return counts(
      held(strong(car), pose({3.0, 4.0}, 0.7, sign * 1.5), {sign * pull.x, pull.y / (top * top)}));
}

TEST(CheckBrakes, of_cars_by_their_sets) {
  for (const bool reverse : {false, true}) {
    const CheckedCar round{.reverse = reverse}, square{.reverse = reverse, .exact_set = true};
    const double cosine = 1.0 / kStrong, sine = std::sqrt(1.0 - cosine * cosine);
    const Vec2 tip{-kStrong, 0.0};
    for (const CheckedCar& car : {round, square}) {
      EXPECT_EQ(counts_of(car, kWithin * tip), kNone);
      EXPECT_EQ(counts_of(car, kBeyond * tip), only(acceleration));
      EXPECT_EQ(counts_of(car, {kBeyond, 0.0}), only(acceleration));
      EXPECT_EQ(counts_of(car, {0.0, -0.999}), kNone);
      const Vec2 touched = car.exact_set ? Vec2{-1.0, 1.0} : Vec2{-cosine, sine};
      const Vec2 edge = 0.5 * (tip + touched);
      EXPECT_EQ(counts_of(car, 0.9999 * edge), kNone);
      EXPECT_EQ(counts_of(car, 1.0001 * edge), only(acceleration));
    }
    EXPECT_EQ(counts_of(square, {-0.99, 0.99}), kNone);
    EXPECT_EQ(counts_of(square, {0.99, 0.99}), kNone);
  }
}

TEST(CheckBrakes, limits_are_positive) {
  CheckedRobot robot = strong();
  robot.max_braking = 0.0;
  EXPECT_THROW(Check({robot}), Error);
}

}  // namespace
}  // namespace avo::test
