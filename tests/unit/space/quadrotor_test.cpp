// SPDX-License-Identifier: Apache-2.0
// The limits of quadrotors, and the set points that a filter makes of their references.
#include "avo/space/quadrotor.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "avo/error.h"
#include "unit/space/flight.h"

namespace avo::space::tests {
namespace {

constexpr double kReserve = 0.8;

// Whether thrust and tilt allow that acceleration.
bool can(const Quadrotor& quadrotor, double min_thrust, Vec3 acceleration) {
  const Vec3 force = quadrotor.mass * (acceleration + Vec3{0.0, 0.0, kGravity});
  const double thrust = norm(force), tilt = std::acos(force.z / thrust);
  return thrust <= quadrotor.max_thrust && thrust >= min_thrust && tilt <= quadrotor.max_tilt;
}

TEST(QuadrotorLimits, are_the_largest_ball_within_thrust_and_tilt_less_the_reserve) {
  Draws draws(1);
  int bound_by_tilt = 0;
  for (int k = 0; k < 300; ++k) {
    Quadrotor quadrotor{.mass = draws.between(0.03, 3.0), .attitude_time = 0.1};
    const double weight = kGravity * quadrotor.mass;
    quadrotor.max_thrust = weight * draws.between(1.05, 3.0);
    if (k % 2 == 0) quadrotor.min_thrust = weight * draws.between(0.0, 0.9);
    quadrotor.max_tilt = draws.between(0.05, 1.2);
    const double least = quadrotor.min_thrust.value_or(0.1 * weight);
    const double ball = limits_of(quadrotor).max_acceleration / kReserve;
    bool is_tight = false;
    for (int j = 0; j < 300; ++j) {
      const Vec3 direction = draws.direction();
      ASSERT_TRUE(can(quadrotor, least, (0.999 * ball) * direction)) << k;
      is_tight = is_tight || !can(quadrotor, least, (1.05 * ball) * direction);
    }
    const Vec3 up{0.0, 0.0, 1.05 * ball};
    is_tight = is_tight || !can(quadrotor, least, up) || !can(quadrotor, least, -up);
    // the cone is touched where the force is at right angles to the acceleration
    const double sine = std::sin(quadrotor.max_tilt), cosine = std::cos(quadrotor.max_tilt);
    if (!can(quadrotor, least, (1.05 * ball) * Vec3{cosine, 0.0, -sine}))
      ++bound_by_tilt, is_tight = true;
    EXPECT_TRUE(is_tight) << k;
  }
  EXPECT_GT(bound_by_tilt, 50);
}

TEST(QuadrotorLimits, declare_a_deviation_unless_one_was_measured) {
  const Quadrotor quadrotor{.mass = 1.2, .max_thrust = 26.0, .max_tilt = 0.5, .attitude_time = 0.1};
  const QuadrotorLimits limits = limits_of(quadrotor);
  EXPECT_NEAR(limits.max_acceleration, 0.8 * kGravity * std::sin(0.5), 1e-12);
  EXPECT_EQ(limits.delay, 0.1);
  EXPECT_NEAR(limits.deviation, limits.max_acceleration * 0.01, 1e-15);
  Quadrotor measured = quadrotor;
  measured.tracking_error = 0.02;
  EXPECT_EQ(limits_of(measured).deviation, 0.02);
}

TEST(QuadrotorLimits, values_out_of_range_are_refused_by_name) {
  const auto refused = [](Quadrotor quadrotor, const char* what) {
    try {
      validate(quadrotor, "robots.3.quadrotor");
      ADD_FAILURE() << what;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(what));
    }
  };
  refused({.mass = 0.0}, "robots.3.quadrotor.mass: found 0, must be > 0 kg");
  refused({.max_thrust = 9.0}, "max_thrust: found 9, must be > 9.80665 N, the weight of its mass");
  refused({.min_thrust = 9.9}, "min_thrust: found 9.9, must be < 9.80665 N");
  refused({.min_thrust = -1.0}, "min_thrust: found -1, must be >= 0 N");
  refused({.max_tilt = 1.6}, "max_tilt: found 1.6, must be <= 1.5 rad");
  refused({.attitude_time = 0.0}, "attitude_time: found 0, must be > 0 s");
  refused({.tracking_error = -0.1}, "tracking_error: found -0.1, must be >= 0 m");
  EXPECT_NO_THROW(validate({}, ""));
}

/// A reference that holds each acceleration over a step.
struct Reference {
  Vec3 position, velocity;
  void move(Vec3 acceleration, double h) {
    position = position + h * velocity + (0.5 * h * h) * acceleration;
    velocity = velocity + h * acceleration;
  }
};

TEST(SetPoints, are_what_two_poles_make_of_the_reference) {
  constexpr double kDelay = 0.3, kStep = 0.1, kTick = 1e-4;
  Filter filter({1.0, 0.0, kDelay}, kDelay, kStep);
  Draws draws(2);
  Reference reference{{1.0, 2.0, 3.0}, {0.5, -0.2, 0.1}};
  // two poles in a row, by Heun's method, begun as if the reference had always been uniform
  constexpr double kPole = 0.5 * kDelay;
  Vec3 once = reference.position - kPole * reference.velocity;
  Vec3 twice = once - kPole * reference.velocity;
  for (int k = 0; k < 40; ++k) {
    const Vec3 acceleration = draws.within(4.0);
    filter.add(reference.position, reference.velocity, acceleration);
    for (int i = 0; i < 1000; ++i) {
      const double time = kStep * k + kTick * i;
      const SetPoint point = filter.at(time);
      ASSERT_LT(norm(point.position - twice), 1e-7) << time;
      ASSERT_LT(norm(point.velocity - (once - twice) / kPole), 1e-6) << time;
      ASSERT_EQ(point.acceleration.x, acceleration.x);
      ASSERT_EQ(point.acceleration.y, acceleration.y);
      Reference next = reference;
      next.move(acceleration, kTick);
      const Vec3 slope = (reference.position - once) / kPole, slope_twice = (once - twice) / kPole;
      const Vec3 then = once + kTick * slope, then_twice = twice + kTick * slope_twice;
      once = once + (0.5 * kTick) * (slope + (next.position - then) / kPole);
      twice = twice + (0.5 * kTick) * (slope_twice + (then - then_twice) / kPole);
      reference = next;
    }
  }
}

TEST(SetPoints, have_the_derivatives_that_they_say) {
  constexpr double kH = 1e-4;
  Filter filter({1.0, 0.0, 0.2}, 0.2, 0.1);
  Reference reference{{}, {1.0, 0.0, -1.0}};
  for (const double sign : {1.0, -1.0, 0.5}) {
    const Vec3 acceleration = sign * Vec3{1.0, -2.0, 3.0};
    filter.add(reference.position, reference.velocity, acceleration);
    const double middle = filter.begin() + 0.05;
    const SetPoint before = filter.at(middle - kH), now = filter.at(middle),
                   after = filter.at(middle + kH);
    EXPECT_LT(norm((after.position - before.position) / (2.0 * kH) - now.velocity), 1e-6);
    EXPECT_NEAR((after.velocity - before.velocity).z / (2.0 * kH), now.acceleration.z, 1e-5);
    reference.move(acceleration, 0.1);
  }
}

TEST(SetPoints, are_within_a_quarter_of_a_t_squared_and_reach_it) {
  double worst = 0.0;
  for (const double step : {0.03, 0.1, 0.4}) {
    for (int kind = 0; kind < 3; ++kind) {
      constexpr double kDelay = 0.2, kAcceleration = 3.0;
      Filter filter({kAcceleration, 0.0, kDelay}, kDelay, step);
      Draws draws(static_cast<std::uint64_t>(kind));
      Reference reference;
      std::vector<Reference> past;  // every tick
      constexpr double kTick = 0.01;
      for (int k = 0; k < 200; ++k) {
        const double sign = kind == 0 && k % 7 < 3 ? -1.0 : 1.0;
        const Vec3 a = kAcceleration * (kind == 1 ? draws.direction() : Vec3{sign, 0.0, 0.0});
        filter.add(reference.position, reference.velocity, a);
        for (int i = 0; i < static_cast<int>(std::lround(step / kTick)); ++i) {
          past.push_back(reference);
          if (past.size() > 20) {
            const Vec3 then = past[past.size() - 21].position;
            const Vec3 point = filter.at(step * k + kTick * i).position;
            const double off = norm(point - then) / (kAcceleration * kDelay * kDelay);
            ASSERT_LE(off, 0.25 + 1e-9) << step << " " << kind;
            worst = std::max(worst, off);
          }
          reference.move(a, kTick);
        }
      }
    }
  }
  EXPECT_GT(worst, 0.2499);
}

TEST(SetPoints, of_a_fleet_wait_for_its_slowest) {
  constexpr double kStep = 0.1;
  Filter at_once({1.0, 0.0, 0.2}, 0.2, kStep), waits({1.0, 0.0, 0.2}, 0.47, kStep);
  Draws draws(3);
  Reference reference{{}, {1.0, 0.0, 0.0}};
  std::vector<SetPoint> points;
  constexpr int kParts = 100, kWait = 270;  // ticks of 1 ms
  for (int k = 0; k < 30; ++k) {
    const Vec3 a = draws.within(2.0);
    at_once.add(reference.position, reference.velocity, a);
    waits.add(reference.position, reference.velocity, a);
    for (int i = 0; i < kParts; ++i) {
      const double time = kStep * k + 0.001 * i;
      points.push_back(at_once.at(time));
      const SetPoint late = waits.at(time);
      if (static_cast<int>(points.size()) <= kWait) {
        EXPECT_EQ(late.acceleration, Vec3{});
        EXPECT_LT(norm(late.position - Vec3{time - 0.47, 0.0, 0.0}), 1e-12);
        continue;
      }
      const SetPoint& then = points[points.size() - 1 - kWait];
      ASSERT_LT(norm(late.position - then.position), 1e-12) << time;
      ASSERT_LT(norm(late.velocity - then.velocity), 1e-12) << time;
    }
    reference.move(a, kStep);
  }
}

TEST(SetPoints, of_numbers_that_are_none_are_refused_and_leave_the_filter_as_it_was) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Filter filter({1.0, 0.0, 0.2}, 0.3, 0.1);
  filter.add({1, 2, 3}, {}, {});
  EXPECT_THROW(filter.add({0, kNone, 0}, {}, {}), Error);
  EXPECT_THROW(filter.add({}, {0, 0, -kFar}, {}), Error);
  EXPECT_THROW(filter.add({}, {}, {kFar, 0, 0}), Error);
  EXPECT_THROW(filter.add({2e12, 0, 0}, {}, {}), Error);
  EXPECT_EQ(filter.end(), 0.1 + (0.3 - 0.2));
  EXPECT_EQ(filter.at(0.1).position, (Vec3{1, 2, 3}));
}

TEST(SetPoints, of_unknown_times_are_refused) {
  Filter filter({1.0, 0.0, 0.2}, 0.3, 0.1);
  EXPECT_THROW((void)filter.at(0.0), Error);
  filter.add({}, {}, {});
  filter.add({}, {}, {});
  EXPECT_NO_THROW((void)filter.at(0.1));
  EXPECT_NO_THROW((void)filter.at(0.3));
  EXPECT_THROW((void)filter.at(0.09), Error);
  EXPECT_THROW((void)filter.at(0.31), Error);
  EXPECT_THROW(Filter({1.0, 0.0, 0.2}, 0.1, 0.1), Error);
  EXPECT_THROW(Filter({1.0, 0.0, 0.0}, 0.1, 0.1), Error);
}

}  // namespace
}  // namespace avo::space::tests
