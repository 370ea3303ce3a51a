// SPDX-License-Identifier: Apache-2.0
// A differential drive stays within its bounds as a holonomic base does, by the point ahead of its
// axle (docs/certificate/execution.md, "Differential drives").
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <string>

#include "avo/error.h"
#include "avo/execution.h"
#include "support/generators.h"
#include "unit/navigator/sluggish_drive.h"

namespace avo {
namespace {

using test::Random;
using test::SluggishDrive;

struct Extremes {
  double position = 0.0, velocity = 0.0, wheel = 0.0;
};

Robot drive_of(double change, double speed) {
  Robot robot;
  robot.model =
      DifferentialDrive{.track = 0.4, .offset = 0.2, .wheel_speed = 2.0, .wheel_acceleration = 4.0};
  robot.max_acceleration = change, robot.max_speed = speed;
  return robot;
}

// The reference is pulled about, faster than a planner would.
void pull(const ExecutionModel& model, const Robot& limits, int cycles, Random& random,
          Extremes& worst) {
  const Planner planner{PlannerOptions{}};
  const double dt = planner.options().time_step;
  ReferenceTracker tracker(model, planner);
  SluggishDrive base;
  base.model = model, base.drive = std::get<DifferentialDrive>(limits.model);
  const auto within = [&](double error) { return error * random.uniform(-1, 1); };
  base.lag = model.time_constant + within(model.time_constant_error);
  // a whole number of the controller's cycles
  base.dead_time = dt / cycles * std::round(cycles / dt * model.dead_time);
  base.heading = random.uniform(-3, 3);
  Robot body = limits;
  Vec2 towards = {};
  for (int k = 0; k < 200; ++k) {
    body.position = base.position() + model.measured_position_error * random.direction();
    body.velocity = base.velocity(), body.heading = base.heading;
    const Robot now = tracker.reference(body);
    if (random.below(6) == 0) towards = random.below(4) == 0 ? Vec2{} : random.direction();
    Vec2 a = limits.max_acceleration * towards;
    if (norm(now.velocity + dt * a) > limits.max_speed) a = {};
    Plan plan;
    plan.acceleration = a, plan.next_velocity = now.velocity + dt * a;
    const BaseCommand command = tracker.follow(body, plan);
    ASSERT_FALSE(command.has_left) << k << ": " << command.deviation;
    base.tell(command.velocity);
    if (random.below(3) == 0) base.error = model.velocity_error * random.direction();
    base.move(dt, cycles, [&](double part) {
      const double t = part * dt;
      const Vec2 p = now.position + t * now.velocity + (0.5 * t * t) * a;
      worst.position = std::max(worst.position, norm(base.position() - p));
      worst.velocity = std::max(worst.velocity, norm(base.velocity() - (now.velocity + t * a)));
    });
  }
}

// None where it turns too fast for what is known of its base.
std::optional<ExecutionError> bound_of(const ExecutionModel& model, const Robot& limits) {
  try {
    return execution_error(model, limits, 0.1);
  } catch (const Error&) {
    return {};
  }
}

TEST(BaseDrive, stays_within_the_bounds_of_its_declaration) {
  Random random(11);
  Extremes largest;
  for (int k = 0; k < 120 && !HasFatalFailure(); ++k) {
    const auto some = [&](double most) { return std::max(0.0, random.uniform(-0.5, 1.0) * most); };
    const int cycles = 10;
    ExecutionModel model{.time_constant = some(0.2), .dead_time = 0.01 * random.below(12)};
    model.time_constant_error = std::min(0.1 * model.time_constant, some(0.02));
    model.deadband = some(0.04), model.quantum = some(0.02), model.velocity_error = some(0.02);
    model.measured_position_error = some(0.002);
    model.heading_age = 0.01;
    const Robot limits = drive_of(random.uniform(0.2, 0.6), random.uniform(0.2, 0.5));
    const auto most = bound_of(model, limits);
    if (!most) continue;
    Extremes worst;
    for (int run = 0; run < 4; ++run) pull(model, limits, cycles, random, worst);
    EXPECT_LE(worst.position, most->position) << k;
    EXPECT_LE(worst.velocity, most->velocity) << k;
    largest.position = std::max(largest.position, worst.position / most->position);
    largest.velocity = std::max(largest.velocity, worst.velocity / most->velocity);
  }
  RecordProperty("position", std::to_string(largest.position));
  RecordProperty("velocity", std::to_string(largest.velocity));
  EXPECT_GT(largest.position, 0.6);
}

// m, of a drive that keeps to wheels' commands of an old heading.
TEST(BaseDrive, age_of_the_heading_cannot_be_left_out) {
  Random random(3);
  const Robot limits = drive_of(0.5, 0.5);
  const ExecutionModel aged{.heading_age = 0.05};
  const double most = execution_error(aged, limits, 0.1).position;
  Extremes worst;
  for (int run = 0; run < 40; ++run) pull(aged, limits, 2, random, worst);
  EXPECT_LE(worst.position, most);
  EXPECT_GT(worst.position, execution_error({}, limits, 0.1).position);
}

// The bound is that of a holonomic base with what the wheels add to its velocity error, and the sum
// that is written out here is the one that the bound has been computed with.
TEST(BaseDrive, bound_has_each_error_of_the_wheels) {
  const double T = 0.1, v = 0.4, offset = 0.2;
  Robot drive = drive_of(0.5, v), holonomic = drive;
  holonomic.model = Holonomic{};
  const auto expect_sum = [&](ExecutionModel model, double rounding, double aged) {
    const ExecutionError found = execution_error(model, drive, 0.1);
    const double V = v + found.velocity;
    const double wrong = model.measured_velocity_error;
    const double turned = V * V * model.time_constant_error + T * wrong * (2.0 * V + wrong);
    const double e = rounding + (turned + V * aged) / offset;
    model.velocity_error = e, model.deadband = 0.0, model.heading_age = 0.0;
    const ExecutionError same = execution_error(model, holonomic, 0.1);
    EXPECT_NEAR(found.position / same.position, 1.0, 1e-4);
    EXPECT_NEAR(found.velocity / same.velocity, 1.0, 1e-4);
  };
  expect_sum({.time_constant = T, .time_constant_error = 0.005}, 0.0, 0.0);
  expect_sum({.time_constant = T, .deadband = 0.04}, 0.02, 0.0);
  expect_sum({.time_constant = T, .measured_velocity_error = 0.01}, 0.0, 0.0);
}

TEST(BaseDrive, fast_turns_on_old_headings_are_refused) {
  EXPECT_FALSE(bound_of({.time_constant = 0.3, .heading_age = 0.2}, drive_of(1.0, 1.0)));
  EXPECT_TRUE(bound_of({.time_constant = 0.1, .heading_age = 0.01}, drive_of(0.5, 0.3)));
}

}  // namespace
}  // namespace avo
