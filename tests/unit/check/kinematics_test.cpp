// SPDX-License-Identifier: Apache-2.0
// The limits of airplanes and of differential drives: what breaks one by a little more than is
// granted counts, and nothing else does.
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

CheckedRobot airplane_of(const CheckedAirplane& airplane) {
  CheckedRobot robot;
  robot.max_acceleration = 2.0;
  robot.max_speed = 15.0;
  robot.kinematics = airplane;
  return robot;
}

TEST(CheckAirplanes, speeds_and_accelerations) {
  const CheckedRobot robot = airplane_of({.min_speed = 10.0, .lateral_acceleration = 5.0});
  const CheckedState start = pose({3, 4}, 0.5, 12.0);
  const double next = 12.2, most = 5.0 / (next * next);
  EXPECT_EQ(counts(held(robot, start, {2.0, most * kWithin})), kNone);
  EXPECT_EQ(counts(held(robot, start, {2.0, most * kBeyond})), only(lateral));
  EXPECT_EQ(counts(held(robot, start, {2.0 * kBeyond, 0.0})), only(acceleration));
  EXPECT_EQ(counts(held(robot, pose({}, 1, 10.0 - 1.4e-8), {})), kNone) << "1e-9 of max_speed";
  const CheckReport report = held(robot, pose({}, 1, 10.0 - 1.6e-8), {});
  EXPECT_EQ(counts(report), only(slow, 2));
  EXPECT_NEAR(report.slow_flights.worst, 1.6e-8, 1e-10);
  EXPECT_EQ(counts(held(robot, pose({}, 1, 15.0 + 1.6e-8), {})), only(speed, 2));
}

// The peaks within the step, by the closed form.
struct Peaks {
  double speed = 0.0, acceleration = 0.0;
};

Peaks peaks_of(const Towed& towed, double track, double duration) {
  Peaks peaks;
  for (int k = 0; k <= 20'000; ++k) {
    const double psi = std::atan2(towed.velocity.y, towed.velocity.x);
    const double off = psi - towed.angle(duration * k / 20'000.0), v = norm(towed.velocity);
    const double c = std::abs(std::cos(off)), s = std::abs(std::sin(off));
    const double lever = 0.5 * track / towed.offset;
    peaks.speed = std::max(peaks.speed, v * (c + lever * s));
    peaks.acceleration =
        std::max(peaks.acceleration, v * v / towed.offset * (s * s + lever * s * c));
  }
  return peaks;
}

CheckedRobot drive_of(const CheckedDrive& drive) {
  CheckedRobot robot;
  robot.radius = 0.3;
  robot.kinematics = drive;
  return robot;
}

// Between the rows too, where neither row is at a wheel's limit.
TEST(CheckDrives, wheels_at_every_instant) {
  Random random(3);
  int within = 0;
  for (int k = 0; k < 150 && !HasFailure(); ++k) {
    const double step = random.log_uniform(0.02, 0.6), track = random.uniform(0.2, 0.8);
    const Towed towed{{3, 4},
                      random.uniform(0.1, 1.5) * random.direction(),
                      random.uniform(-2.5, 2.5),
                      random.uniform(0.15, 0.5)};
    const Peaks peaks = peaks_of(towed, track, step);
    const auto judged = [&](double speed, double acceleration) {
      return counts(report_of({drive_of({track, towed.offset, speed, acceleration})},
                              {{0.0, {towed.row(0.0)}}, {step, {towed.row(step)}}}));
    };
    const double little = 1e-6;  // of a peak may be missed
    const double speed = peaks.speed, pull = peaks.acceleration;
    EXPECT_EQ(judged(speed * (1 + little), pull * (1 + little)), kNone) << k;
    EXPECT_EQ(judged(speed * (1 - little), pull * (1 + little)), only(wheel_speed)) << k;
    EXPECT_EQ(judged(speed * (1 + little), pull * (1 - little)), only(wheel_acceleration)) << k;
    Towed later = towed;
    later.off = std::atan2(towed.velocity.y, towed.velocity.x) - towed.angle(step);
    const double at_rows = std::max(peaks_of(towed, track, 0.0).acceleration,
                                    peaks_of(later, track, 0.0).acceleration);
    if (peaks.acceleration > 1.001 * at_rows) ++within;
  }
  EXPECT_GT(within, 8);
}

TEST(CheckDrives, straight_ahead_the_wheels_have_the_speed_of_the_axle) {
  const auto judged = [](double speed, double change, const CheckedDrive& drive) {
    const CheckedState from = pose({3, 4}, 0.5, speed);
    return counts(held(drive_of(drive), from, {change, 0.0}));
  };
  const CheckedDrive drive{0.4, 0.2, 1.2, 0.7};
  EXPECT_EQ(judged(1.2 * kWithin, 0.0, drive), kNone);
  EXPECT_EQ(judged(1.2 * kBeyond, 0.0, drive), only(wheel_speed));
  EXPECT_EQ(judged(-1.2 * kBeyond, 0.0, drive), only(wheel_speed)) << "backwards as well";
  EXPECT_EQ(judged(0.3, -0.7 * kWithin, drive), kNone);
  EXPECT_EQ(judged(0.3, -0.7 * kBeyond, drive), only(wheel_acceleration));
  EXPECT_EQ(judged(0.3, kBeyond, {0.4, 0.2, 1.2, 2.0}), only(acceleration)) << "of the point";
}

TEST(CheckDrives, heading_speed_and_place_follow_the_point) {
  const CheckedRobot robot = drive_of({});
  const Towed towed{{3, 4}, {0.8, 0.3}, 0.7, 0.2};
  const CheckedState from = towed.row(0.0);
  const auto changed = [&](const auto& change) {
    CheckedState to = towed.row(kStep);
    change(to);
    return counts(step_of(robot, from, to));
  };
  EXPECT_EQ(changed([](CheckedState&) {}), kNone);
  EXPECT_EQ(changed([](CheckedState& to) { to.heading->speed += 1.9e-9; }), kNone);
  EXPECT_EQ(changed([](CheckedState& to) { to.heading->speed += 2.1e-9; }), only(heading));
  // the tolerance is 1e-9 of 0.3 m of radius, 0.085 m of path and 0.2 m of offset
  EXPECT_EQ(changed([](CheckedState& to) { to.position.x += 0.5e-9; }), kNone);
  EXPECT_EQ(changed([](CheckedState& to) { to.position.x += 0.7e-9; }), only(jump));
  const auto turned_on = [](double angle) {
    return [angle](CheckedState& to) {
      to.heading->angle += angle;
      to.heading->speed = dot(along(to.heading->angle), to.velocity);
    };
  };
  EXPECT_EQ(changed(turned_on(2.5e-9)), kNone);
  EXPECT_EQ(changed(turned_on(3.5e-9)), only(jump));
}

TEST(CheckKinematics, numbers_out_of_range_are_refused) {
  const auto said = [](const CheckedKinematics& kinematics) {
    CheckedRobot robot;
    robot.kinematics = kinematics;
    return refusal([&] { Check check({robot}); });
  };
  EXPECT_EQ(said(CheckedCar{}), "");
  EXPECT_EQ(said(CheckedCar{.wheelbase = 0.0}),
            "robots.0.kinematics.wheelbase: found 0, must be > 0 m");
  EXPECT_EQ(said(CheckedCar{.max_curvature = -1.0}),
            "robots.0.kinematics.max_curvature: found -1, must be > 0 1/m");
  EXPECT_EQ(said(CheckedDrive{.track = 0.0}), "robots.0.kinematics.track: found 0, must be > 0 m");
  EXPECT_EQ(said(CheckedAirplane{.min_speed = -1.0}),
            "robots.0.kinematics.min_speed: found -1, must be >= 0 m/s");
  const CheckedState lost = pose({}, std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_NE(refusal([&] {
              report_of({airplane_of({})}, {{0.0, {{0, {}, {}, lost.heading}}}});
            }).find("robot 0: heading: found nan"),
            std::string::npos);
}

}  // namespace
}  // namespace avo::test
