// SPDX-License-Identifier: Apache-2.0
// The limits of cars: what breaks one by a little more than is granted counts, and nothing else
// does.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "support/generators.h"
#include "unit/check/rules.h"

namespace avo::test {
namespace {

CheckedRobot car_of(const CheckedCar& car, double max_acceleration = 1.0) {
  CheckedRobot robot;
  robot.max_acceleration = max_acceleration;
  robot.kinematics = car;
  return robot;
}

// Random cars within their limits, far from the origin too.
TEST(CheckCars, what_keeps_its_limits_breaks_none) {
  Random random(1);
  for (int k = 0; k < 20'000 && !HasFailure(); ++k) {
    CheckedCar car;
    car.max_curvature = k % 2 == 0 ? random.log_uniform(0.1, 10.0) : 1.0 / 0.0;
    car.reverse = k % 3 == 0;
    car.exact_set = k % 5 == 0;
    car.body_offset = k % 7 == 0 ? random.uniform(-1, 1) : 0.0;
    const double sign = car.reverse && k % 2 == 0 ? -1.0 : 1.0, step = random.log_uniform(0.01, 1);
    const double angle = random.uniform(-3.2, 3.2), from = random.uniform(0.0, 2.0);
    Vec2 pull =
        car.exact_set ? Vec2{random.uniform(-1, 1), random.uniform(-1, 1)} : in_disc(random, 1.0);
    if (k % 4 == 0) pull = {std::copysign(1.0, pull.x), 0.0};
    const double to = std::clamp(from + pull.x * step, 0.0, 2.0), top = std::max(from, to);
    const double half_turn = 3.0 / (std::max(from, to) * step);  // a heading tells no full turns
    const double most = std::min({car.max_curvature, std::abs(pull.y) / (top * top), half_turn});
    const double far = k % 11 == 0 ? 1e6 : 10.0;
    const Vec2 place{random.uniform(-far, far), random.uniform(-far, far)};
    const CheckedState start = pose(place, angle, sign * from);
    const Held controls{sign * (to - from) / step, std::copysign(most, pull.y)};
    const CheckReport report =
        report_of({car_of(car)}, {{far, {start}}, {far + step, {driven(start, controls, step)}}});
    EXPECT_EQ(counts(report), kNone) << k;
    EXPECT_TRUE(report.safe());
  }
}

// p' = s (cos θ, sin θ), θ' = s κ, s' held, in small steps.
TEST(CheckCars, what_solves_the_equations_of_a_car_breaks_none) {
  Random random(2);
  const CheckedRobot robot = car_of({.reverse = true, .exact_set = true}, 1.0 / 0.0);
  for (int k = 0; k < 50; ++k) {
    constexpr int kParts = 5'000;
    const double change = random.uniform(-1, 1), curvature = random.uniform(-2, 2);
    const CheckedState start = pose({3, 4}, random.uniform(-3, 3), random.uniform(-1.8, -0.2));
    Vec2 place = start.position;
    double angle = start.heading->angle;
    for (int i = 0; i < kParts; ++i) {
      const double s = start.heading->speed + change * kStep * (i + 0.5) / kParts;
      const double middle = angle + 0.5 * s * curvature * kStep / kParts;
      place = place + (s * kStep / kParts) * along(middle);
      angle += s * curvature * kStep / kParts;
    }
    const CheckedState end = pose(place, angle, start.heading->speed + change * kStep);
    EXPECT_EQ(counts(step_of(robot, start, end)), kNone) << k;
    const CheckedState off = pose(place + Vec2{1e-8, 0}, angle, end.heading->speed);
    EXPECT_EQ(counts(step_of(robot, start, off)), only(jump)) << k;
  }
}

TEST(CheckCars, curvature) {
  const CheckedRobot robot = car_of({.max_curvature = 0.8}, 1.0 / 0.0);
  const CheckedState start = pose({3, 4}, 1.0, 1.5);
  // 0.12 rad, of which 1e-9 is granted, and 1e-9 rad besides
  EXPECT_EQ(counts(held(robot, start, {0.0, 0.8 * (1.0 + 0.9e-8)})), kNone);
  const CheckReport report = held(robot, start, {0.0, 0.8 * (1.0 + 1.1e-8)});
  EXPECT_EQ(counts(report), only(turn));
  EXPECT_FALSE(report.safe());
  EXPECT_EQ(report.turns.first->time, 0.0);
  EXPECT_NEAR(held(robot, start, {0.5, -1.0}).turns.worst, 0.2 * 0.1525, 1e-12) << "rad beyond";
}

TEST(CheckCars, lateral_acceleration_is_that_of_the_higher_speed) {
  const CheckedRobot robot = car_of({.exact_set = true});
  const CheckedState start = pose({3, 4}, -2.0, 1.5);
  const double next = 1.55, most = 1.0 / (next * next);
  EXPECT_EQ(counts(held(robot, start, {0.5, most * kWithin})), kNone);
  const CheckReport report = held(robot, start, {0.5, most * kBeyond});
  EXPECT_EQ(counts(report), only(lateral));
  EXPECT_NEAR(report.lateral_accelerations.worst, 1.2e-9, 1e-11);
  EXPECT_EQ(counts(held(robot, driven(start, {0.5, most}, kStep), {-0.5, 1.01 * most})),
            only(lateral))
      << "braking on the same circle";
}

TEST(CheckCars, both_accelerations_together_or_each_alone) {
  const CheckedState start = pose({3, 4}, 0.5, 1.0);
  const auto at = [&](bool exact, Vec2 pull) {
    const double top = 1.0 + std::max(pull.x, 0.0) * kStep;
    return counts(held(car_of({.exact_set = exact}), start, {pull.x, pull.y / (top * top)}));
  };
  EXPECT_EQ(at(false, kWithin * Vec2{0.6, -0.8}), kNone);
  EXPECT_EQ(at(false, kBeyond * Vec2{0.6, -0.8}), only(acceleration));
  EXPECT_EQ(at(true, kWithin * Vec2{-1, 1}), kNone);
  EXPECT_EQ(at(true, {-kBeyond, 1}), only(acceleration));
  EXPECT_EQ(at(true, {-1, kBeyond}), only(lateral));
  const auto largest = [&](bool exact) {
    return held(car_of({.exact_set = exact}), start, {-0.5, 0.9}).largest_acceleration;
  };
  EXPECT_NEAR(largest(true), 0.9, 1e-9) << "each alone";
  EXPECT_NEAR(largest(false), std::sqrt(0.25 + 0.81), 1e-9);
}

TEST(CheckCars, reverse_gear) {
  const CheckedState start = pose({3, 4}, 0.5, -1.0);
  EXPECT_EQ(counts(held(car_of({.reverse = true}), start, {0.5, 0.3})), kNone);
  EXPECT_EQ(counts(held(car_of({}), start, {0.5, 0.3})), only(reversal));
  // 1e-9 of max_speed is granted
  EXPECT_EQ(counts(held(car_of({}), pose({}, 0.0, -1.9e-9), {})), kNone);
  EXPECT_EQ(counts(held(car_of({}), pose({}, 0.0, -2.1e-9), {})), only(reversal));
}

TEST(CheckCars, the_gear_changes_where_steps_end) {
  const CheckedRobot robot = car_of({.reverse = true});
  const CheckedState start = pose({3, 4}, 0.5, -0.05);
  EXPECT_EQ(counts(held(robot, start, {0.5, 0.0})), kNone);
  EXPECT_EQ(counts(held(robot, start, {0.9, 0.0})), only(reversal));
}

TEST(CheckCars, velocities_along_the_heading) {
  const CheckedRobot robot = car_of({});
  const CheckedState start = pose({3, 4}, 0.5, 1.0);
  CheckedState next = driven(start, {}, kStep);
  const Vec2 left{-std::sin(0.5), std::cos(0.5)};
  next.velocity = next.velocity + 1.9e-9 * left;  // of 2 m/s
  EXPECT_EQ(counts(step_of(robot, start, next)), kNone);
  next.velocity = next.velocity + 0.2e-9 * left;
  EXPECT_EQ(counts(step_of(robot, start, next)), only(heading));
  next = driven(start, {}, kStep);
  next.velocity = -next.velocity;
  EXPECT_EQ(counts(step_of(robot, start, next)), only(heading)) << "it says that it drives forward";
}

// A heading that does not fit where it went, though it does fit the velocity.
TEST(CheckCars, positions_on_the_arc) {
  const CheckedRobot robot = car_of({});
  const CheckedState start = pose({3, 4}, 0.5, 1.0);
  CheckedState next = driven(start, {0.0, 0.5}, kStep);
  next.position = next.position + Vec2{0.55e-9, 0};  // 1e-9 of 0.5 m of radius and 0.1 m of path
  EXPECT_EQ(counts(step_of(robot, start, next)), kNone);
  next.position = next.position + Vec2{0.1e-9, 0};
  EXPECT_EQ(counts(step_of(robot, start, next)), only(jump));
  const CheckedState turned = pose(start.position + kStep * along(0.5), 0.5001, 1.0);
  EXPECT_EQ(counts(step_of(robot, start, turned)), only(jump));
  EXPECT_NEAR(step_of(robot, start, turned).jumps.worst, 5e-6, 1e-8);
}

// The front axle, one wheelbase ahead, moves at max_speed: 2 m/s.
TEST(CheckCars, turning_in_place) {
  const auto turned = [](CheckedCar car, double angle) {
    return counts(step_of(car_of(car), pose({3, 4}, 3.0, 0.0),
                          pose({3, 4}, std::remainder(3.0 + angle, 6.283185307179586), 0.0)));
  };
  EXPECT_EQ(turned({.wheelbase = 0.5}, 0.4), kNone);
  EXPECT_EQ(turned({.wheelbase = 0.5}, -0.4 - 1.3e-9), kNone) << "1e-9 rad, and of 0.4";
  EXPECT_EQ(turned({.wheelbase = 0.5}, -0.4 - 1.5e-9), only(turn));
  EXPECT_EQ(turned({.max_curvature = 0.8}, 0.9e-9), kNone);
  EXPECT_EQ(turned({.max_curvature = 0.8}, 1.1e-9), only(turn));
}

TEST(CheckCars, a_parked_one_stays_as_it_is) {
  CheckedRobot robot = car_of({.body_offset = 0.3});
  robot.parked = true;
  const CheckedState start = pose({3, 4}, 3.0, 0.0);
  EXPECT_EQ(counts(step_of(robot, start, start)), kNone);
  EXPECT_EQ(counts(step_of(robot, start, pose({3, 4}, 3.01, 0.0))), only(turn));
}

// Without headings the velocities are all there is.
TEST(CheckCars, rows_without_headings) {
  const CheckedState from{0, {}, {1, 0}}, to{0, {0.1, 0.0}, {1, 0}};
  const CheckReport report = step_of(car_of({.max_curvature = 0.8}), from, to);
  EXPECT_EQ(counts(report), kNone);
  EXPECT_EQ(report.without_heading, 1);
  EXPECT_EQ(step_of(car_of({}), pose({}, 0, 1), pose({0.1, 0}, 0, 1)).without_heading, 0);
  const auto pulled = [](bool exact, Vec2 change) {
    return step_of(car_of({.exact_set = exact}), {0, {}, {1, 0}},
                   {0, {0.1, 0}, Vec2{1, 0} + kStep * change})
        .accelerations.count;
  };
  EXPECT_EQ(pulled(false, {1.1, 0}), 1);
  EXPECT_EQ(pulled(true, {1, 1}), 0) << "a corner of its square, however it faces";
  EXPECT_EQ(pulled(true, {1.1, 1}), 1);
  for (const CheckedKinematics& kinematics :
       {CheckedKinematics{CheckedCar{.body_offset = 0.1}}, CheckedKinematics{CheckedDrive{}}}) {
    CheckedRobot robot;
    robot.kinematics = kinematics;
    EXPECT_EQ(refusal([&] { step_of(robot, from, to); }),
              "robot 0: heading: found none, must be there: its disc, or what its velocity is of, "
              "is ahead of its position");
  }
}

}  // namespace
}  // namespace avo::test
