// SPDX-License-Identifier: Apache-2.0
// Differential drives against the integration of their wheels (support/wheels.h): the step, the
// lemma on braking, which decisions are followed.
#include "robots/drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <numbers>
#include <thread>
#include <vector>

#include "avo/simd.h"
#include "core/elementary.h"
#include "core/robot_columns.h"
#include "robots/ahead.h"
#include "robots/directions.h"
#include "support/generators.h"
#include "support/half_plane_batches.h"
#include "support/wheels.h"

namespace avo {
namespace {

using test::angle_between;
using test::AxleState;
using test::Random;
using test::WheelUse;

struct Drawn {
  DifferentialDrive drive;
  double max_acceleration = 0.0;
  MotionState state;
};

Vec2 at_angle(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

// Any drive in any state of S, every third on its boundary.
Drawn drawn(Random& random) {
  Drawn d;
  d.drive.track = random.log_uniform(0.1, 2.0);
  d.drive.offset = random.log_uniform(0.05, 1.0);
  d.drive.wheel_speed = random.log_uniform(0.2, 4.0);
  d.drive.wheel_acceleration = random.log_uniform(0.3, 6.0);
  d.max_acceleration = random.uniform(0.05, 0.95) * most_acceleration(d.drive);
  d.state.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  const double off = random.uniform(-std::numbers::pi, std::numbers::pi);
  const double most = most_speed(d.drive, d.max_acceleration, std::cos(off), std::sin(off));
  const double part = random.uniform(0.0, 1.5);
  d.state.velocity = at_angle(std::min(part, 1.0) * most, d.state.heading + off);
  return d;
}

Plan plan_by(Vec2 acceleration) {
  Plan plan;
  plan.acceleration = acceleration;
  return plan;
}

TEST(Drive, q_moves_on_a_parabola_and_the_axle_follows) {
  Random random(31);
  double turned = 0.0;
  for (int k = 0; k < 2'000 && !HasFailure(); ++k) {
    Drawn d = drawn(random);
    d.state.position = test::in_disc(random, 10.0);
    const Vec2 a = test::in_disc(random, d.max_acceleration);
    const double dt = random.log_uniform(0.02, 0.2);
    AxleState axle = test::axle_of(d.drive, d.state.position, d.state.velocity, d.state.heading);
    integrate(d.drive, axle, a, dt, 400);
    const MotionStep step = advance_drive(d.drive, d.state, plan_by(a), dt);
    EXPECT_LT(norm(step.next.position - center_of(d.drive, axle)), 1e-7);
    EXPECT_LT(norm(step.next.velocity - center_velocity(d.drive, axle)), 1e-6);
    EXPECT_LT(angle_between(step.next.heading, axle.heading), 5e-7);
    EXPECT_EQ(step.bend, 0.0);
    EXPECT_GE(step.length, norm(step.next.position - d.state.position) * (1.0 - 1e-12));
    turned = std::max(turned, angle_between(step.next.heading, d.state.heading));
  }
  EXPECT_GT(turned, 0.5);
}

// Wheels at `substeps` instants of every step until rest; false where S was left.
bool brakes_within_limits(const Drawn& d, double deceleration, double dt, int substeps,
                          WheelUse& worst) {
  AxleState axle = test::axle_of(d.drive, {}, d.state.velocity, d.state.heading);
  double speed = norm(d.state.velocity);
  const Vec2 back = speed > 0.0 ? (-1.0 / speed) * d.state.velocity : Vec2{};
  while (speed > 0.0) {
    const double time = std::min(dt, speed / deceleration);
    WheelUse use = integrate(d.drive, axle, deceleration * back, time, substeps);
    use.speed /= d.drive.wheel_speed, use.acceleration /= d.drive.wheel_acceleration;
    worst.take(use);
    speed -= deceleration * dt;
    if (!(speed > 0.0)) break;
    const Vec2 v = center_velocity(d.drive, axle);
    const double along = std::cos(axle.heading) * v.x + std::sin(axle.heading) * v.y;
    const double across = std::cos(axle.heading) * v.y - std::sin(axle.heading) * v.x;
    if (speed >
        (1.0 + 1e-6) * most_speed(d.drive, d.max_acceleration, along / speed, across / speed))
      return false;
  }
  return true;
}

// The lemma: from any state of S, with any deceleration up to a_D.
void expect_braking_within_limits(int brakings, std::uint64_t seed) {
  Random random(seed);
  WheelUse worst;
  for (int k = 0; k < brakings && !testing::Test::HasFailure(); ++k) {
    const Drawn d = drawn(random);
    const double part = k % 4 == 0 ? random.uniform(0.3, 1.0) : 1.0;
    const double least = norm(d.state.velocity) / (100.0 * d.max_acceleration);  // s
    const double dt = std::max(random.log_uniform(0.02, 0.3), least);
    EXPECT_TRUE(brakes_within_limits(d, part * d.max_acceleration, dt, 16, worst)) << k;
    EXPECT_LE(worst.speed, 1.0 + 1e-6) << k;
    EXPECT_LE(worst.acceleration, 1.0 + 1e-6) << k;
  }
  EXPECT_GT(worst.speed, 0.999);
  EXPECT_GT(worst.acceleration, 0.9);
  testing::Test::RecordProperty("worst_acceleration", std::to_string(worst.acceleration));
  std::printf("%d brakings: at most %.6f of the wheels' acceleration, %.6f of their speed\n",
              brakings, worst.acceleration, worst.speed);
}

TEST(Drive, in_the_midst_of_a_step_it_is_where_a_shorter_one_ends) {
  Random random(23);
  for (int k = 0; k < 2000; ++k) {
    const Drawn d = drawn(random);
    const double step = random.log_uniform(0.02, 0.5), time = random.uniform(0.01, 0.99) * step;
    const Plan plan = plan_by(test::in_disc(random, d.max_acceleration));
    const MotionState to = advance_drive(d.drive, d.state, plan, step).next;
    const MotionState now = within_step(d.drive, d.state, to, time, step);
    const MotionState shorter = advance_drive(d.drive, d.state, plan, time).next;
    EXPECT_NEAR(norm(now.position - shorter.position), 0.0, 1e-12) << k;
    EXPECT_NEAR(norm(now.velocity - shorter.velocity), 0.0, 1e-12) << k;
    EXPECT_LT(angle_between(now.heading, shorter.heading), 1e-12) << k;
    const MotionState start = within_step(d.drive, d.state, to, 0.0, step);
    EXPECT_EQ(start.heading, d.state.heading);
  }
}

TEST(Drive, braking_straight_keeps_S_and_the_wheels_within_their_limits) {
  expect_braking_within_limits(20'000, 32);
}

// By scripts/soak safety.
TEST(Drive, DISABLED_a_million_brakings) {
  expect_braking_within_limits(1'000'000, 33);
}

// S is not smaller than it has to be: beyond its boundary braking breaks a limit.
TEST(Drive, S_is_sharp_where_the_lemma_says_so) {
  const DifferentialDrive drive{
      .track = 0.4, .offset = 0.2, .wheel_speed = 1.2, .wheel_acceleration = 2.0};
  EXPECT_NEAR(most_acceleration(drive), std::sqrt(2.0), 1e-15);
  const double a = 0.5 * most_acceleration(drive);
  EXPECT_NEAR(most_speed(drive, a, 1.0, 0.0), 1.2, 1e-15);
  // 1 m/s² is left for V² G/L: in any direction up to √(L/1.2071)
  EXPECT_NEAR(most_speed(drive, a, -1.0, 0.0), std::sqrt(0.2 / (0.5 + std::sqrt(0.5))), 1e-12);
  EXPECT_NEAR(most_speed(drive, a, 0.0, 1.0), 0.40705, 1e-5);
  EXPECT_NEAR(most_speed(drive, a, 0.0, -1.0), 0.40705, 1e-5);
  const double ten = 10.0 / 180.0 * std::numbers::pi;
  EXPECT_GT(most_speed(drive, a, std::cos(ten), std::sin(ten)), 0.98);
  // there either the wheels accelerate by all that braking leaves them, or they are at full speed
  for (const double off : {-1.0, -0.6, -0.05, 0.05, 0.6, 1.0}) {
    const double most = most_speed(drive, a, std::cos(off), std::sin(off));
    const AxleState axle = test::axle_of(drive, {}, at_angle(most, off), 0.0);
    const WheelUse use = test::use_of(drive, axle, {});
    const bool by_speed = std::abs(off) < 0.1;
    EXPECT_NEAR(use.speed, 1.2, by_speed ? 1e-12 : 1.0) << off;
    EXPECT_NEAR(use.acceleration, 1.0, by_speed ? 1.0 : 1e-12) << off;
  }
}

// Whatever is followed keeps the limits at 200 instants, and leads into S; and what is refused
// breaks them, nearly always.
TEST(Drive, follows_what_the_wheels_can_and_no_more) {
  Random random(34);
  int followed = 0, refused = 0, wrongly = 0;
  for (int k = 0; k < 30'000 && !HasFailure(); ++k) {
    const Drawn d = drawn(random);
    const double dt = random.log_uniform(0.02, 0.4);
    const Vec2 a = test::in_disc(random, d.max_acceleration);
    const Vec2 next = d.state.velocity + dt * a;
    const bool follows_it = follows(d.drive, d.max_acceleration, d.state, next, dt);
    AxleState axle = test::axle_of(d.drive, {}, d.state.velocity, d.state.heading);
    const WheelUse use = integrate(d.drive, axle, a, dt, 200);
    const double speed = norm(next), off = std::atan2(next.y, next.x) - axle.heading;
    const double most = most_speed(d.drive, d.max_acceleration, std::cos(off), std::sin(off));
    const bool could = use.speed <= d.drive.wheel_speed &&
                       use.acceleration <= d.drive.wheel_acceleration && speed <= most;
    if (follows_it) {
      EXPECT_TRUE(could) << k << ": wheels " << use.speed / d.drive.wheel_speed << ' '
                         << use.acceleration / d.drive.wheel_acceleration << ", speed "
                         << speed / most;
    }
    follows_it ? ++followed : ++refused;
    if (could && !follows_it) ++wrongly;
  }
  EXPECT_GT(followed, 10'000);
  EXPECT_GT(refused, 3'000);
  EXPECT_LT(wrongly, 700);  // 2 %
}

// From rest in every direction, at once: the whole disc of accelerations.
TEST(Drive, leaves_from_rest_in_every_direction) {
  const DifferentialDrive drive;
  for (int k = 0; k < 360; ++k) {
    const Vec2 next = at_angle(0.1, k * std::numbers::pi / 180.0);
    EXPECT_TRUE(follows(drive, 1.0, {{}, {}, 0.7}, next, 0.1)) << k;
  }
  EXPECT_FALSE(follows(drive, 1.0, {{}, {}, 0.7}, at_angle(1.0, 3.0), 0.1));
}

TEST(Drive, brakes_to_rest_exactly) {
  Random random(35);
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    const Drawn d = drawn(random);
    const MotionStep step = advance_drive(d.drive, d.state, plan_by(-10.0 * d.state.velocity), 0.1);
    EXPECT_EQ(step.next.velocity, Vec2{});
  }
}

// On and ahead of the axle, driving and turning in place.
Car any_car(Random& random) {
  Car car;
  if (random.below(2) == 0) car.max_curvature = random.log_uniform(0.1, 3.0);
  if (random.below(2) == 0) car.body = CarBody{random.uniform(-1.0, 1.0), 0.5};
  car.reverse = random.below(2) == 0;
  return car;
}

// The drives in the lanes take different numbers of substeps. Each drive moves as the drive does
// alone, and each car does too.
TEST(Drive, of_those_that_move_together_each_moves_as_it_does_alone) {
  Random random(37);
  std::array<Plan, kMostModelSteps> plans;
  std::array<MotionModel, kMostModelSteps> models;
  for (int k = 0; k < 20'000 && !HasFailure(); ++k) {
    std::vector<ModelStep> steps;
    const auto count = static_cast<std::size_t>(1 + random.below(kMostModelSteps));
    for (std::size_t n = 0; n < count; ++n) {
      Drawn d = drawn(random);
      const bool drives = random.below(4) > 0;
      models[n] = drives ? MotionModel{d.drive} : MotionModel{any_car(random)};
      if (!drives)
        d.state.velocity =
            d.max_acceleration * random.uniform(0.0, 2.0) * ahead_of(d.state.heading);
      if (!drives && random.below(2) == 0) d.state.velocity = {};
      plans[n] = plan_by(test::in_disc(random, d.max_acceleration));
      plans[n].new_velocity = d.state.velocity + plans[n].acceleration;
      steps.push_back({&models[n], {d.max_acceleration, d.drive.wheel_speed}, d.state, &plans[n]});
    }
    advance_together(steps, 0.1);
    for (const ModelStep& step : steps) {
      const MotionStep alone = advance(*step.model, step.limits, step.state, *step.plan, 0.1);
      EXPECT_EQ(step.result.next.position, alone.next.position);
      EXPECT_EQ(step.result.next.velocity, alone.next.velocity);
      EXPECT_EQ(step.result.next.heading, alone.next.heading);
      EXPECT_EQ(step.result.acceleration, alone.acceleration);
      EXPECT_EQ(step.result.bend, alone.bend);
      EXPECT_EQ(step.result.length, alone.length);
      EXPECT_EQ(step.result.swing, alone.swing);
    }
  }
}

// Headings that are asked for again and again, and many more than are remembered; a thread begins
// with none.
TEST(Drive, a_direction_that_is_remembered_is_that_of_the_heading) {
  Random random(38);
  std::vector<double> headings = {0.0, -0.0, 1e-9, -1e-9, std::numbers::pi, -std::numbers::pi};
  for (int k = 0; k < 1'000; ++k) headings.push_back(random.uniform(-4.0, 4.0));
  int wrong = 0;
  const auto ask = [&](double heading) {
    const Vec2 found = ahead_of(heading), expected = elementary::direction(heading);
    wrong += found == expected && std::signbit(found.y) == std::signbit(expected.y) ? 0 : 1;
  };
  std::thread([&] {
    for (const double heading : headings) ask(heading);
    for (int k = 0; k < 200'000; ++k) {
      const int among = random.below(2) == 0 ? 40 : static_cast<int>(headings.size());
      ask(headings[static_cast<std::size_t>(random.below(among))]);
    }
  }).join();
  EXPECT_EQ(wrong, 0);
}

bool are_same_bits(Vec2 a, Vec2 b) {
  return a == b && std::signbit(a.x) == std::signbit(b.x) && std::signbit(a.y) == std::signbit(b.y);
}

// In each quadrant, near its ends, next to nothing, and as far off as may be.
TEST(Drive, directions_found_in_lanes_have_the_bits_of_each_alone) {
  Random random(39);
  std::vector<double> angles = {0.0, -0.0, 0x1p-27, -0x1p-27, 0x1p-28, 1e-300, kMostAngle};
  for (int k = -40; k <= 40; ++k) {
    const double end = k * (0.25 * std::numbers::pi);
    angles.insert(angles.end(), {std::nextafter(end, -100.0), end, std::nextafter(end, 100.0)});
  }
  for (int k = 0; k < 20'000; ++k) angles.push_back(random.uniform(-7.0, 7.0));
  for (int k = 0; k < 20'000; ++k)
    angles.push_back(std::copysign(random.log_uniform(1e-10, kMostAngle), random.uniform(-1, 1)));
  const std::size_t count = angles.size();
  angles.resize(count + kSpareAngles);
  std::vector<double> x(angles.size()), y(angles.size());
  for (const char* target : simd_targets()) {
    const test::OnTarget on(target);
    find_directions(angles.data(), count, x.data(), y.data());
    for (std::size_t k = 0; k < count && !HasFailure(); ++k)
      EXPECT_TRUE(are_same_bits({x[k], y[k]}, elementary::direction(angles[k])))
          << target << ' ' << angles[k];
  }
}

// More robots than are looked at together, some of them without a heading.
TEST(Drive, directions_of_many_robots_are_those_of_their_headings) {
  Random random(40);
  const MotionModel model = Car{};
  RobotColumns robots;
  robots.reserve(150);
  for (int k = 0; k < 150; ++k) {
    Robot robot;
    robot.heading = random.uniform(-4.0, 4.0);
    robots.add(robot, {});
    if (k % 3 != 0) robots.model.back() = &model;
  }
  look_ahead(robots);
  for (std::size_t k = 0; k < robots.count; ++k)
    EXPECT_TRUE(
        are_same_bits(ahead_of(robots.heading[k]), elementary::direction(robots.heading[k])));
}

// A robot as its planner sees it: the farthest that can be followed, or braking.
TEST(Drive, comes_as_near_to_a_wish_as_its_wheels_can) {
  Random random(36);
  int partly = 0;
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const Drawn d = drawn(random);
    Robot robot;
    robot.velocity = d.state.velocity, robot.heading = d.state.heading;
    robot.max_acceleration = d.max_acceleration, robot.max_speed = d.drive.wheel_speed;
    robot.model = d.drive;
    const double u = 0.1 * d.max_acceleration, speed = norm(robot.velocity);
    const Vec2 backup = speed > u ? ((speed - u) / speed) * robot.velocity : Vec2{};
    const Vec2 wanted = robot.velocity + test::in_disc(random, u);
    const Vec2 next = within_own_limits(robot, 0.1, wanted);
    if (next == backup) continue;
    EXPECT_TRUE(follows(d.drive, d.max_acceleration, d.state, next, 0.1));
    const double part = norm(next - backup) / norm(wanted - backup);
    EXPECT_LE(part, 1.0 + 1e-9);
    if (next == wanted) continue;
    ++partly;
    const Vec2 more = next + (1.0 / 32.0) * (wanted - backup);
    EXPECT_FALSE(part < 0.9 && follows(d.drive, d.max_acceleration, d.state, more, 0.1) &&
                 follows(d.drive, d.max_acceleration, d.state, wanted, 0.1));
  }
  EXPECT_GT(partly, 100);
}

}  // namespace
}  // namespace avo
