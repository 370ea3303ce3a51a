// SPDX-License-Identifier: Apache-2.0
// A base that does not execute exactly stays within the declared deviation of its reference, and no
// term of the bound can be left out (docs/certificate/execution.md).
#include "avo/execution.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/error.h"
#include "support/generators.h"
#include "unit/navigator/sluggish_base.h"

namespace avo {
namespace {

using test::SluggishBase;

constexpr int kParts = 16;  // of a step, at which deviations are measured

// What a driver may want of the reference, and what the base may do within its declaration.
struct Adversary {
  test::Random random;
  Vec2 towards = {1, 0};
  int for_steps = 0;

  Vec2 acceleration(Vec2 deviation, double most) {
    if (--for_steps < 0) {
      for_steps = static_cast<int>(random.uniform(0, 12));
      const double angle = random.uniform(0, 6.283185307179586);
      towards = {std::cos(angle), std::sin(angle)};
      if (random.uniform(0, 1) < 0.5 && norm(deviation) > 0.0)
        towards = (-1.0 / norm(deviation)) * deviation;  // the reference flees from the base
      if (random.uniform(0, 1) < 0.2) towards = {};
    }
    return most * towards;
  }
};

struct Worst {
  double position = 0.0, velocity = 0.0, command = 0.0;
};

// The true constants, at an end of what is declared or anywhere between.
SluggishBase base_of(const ExecutionModel& model, test::Random& random) {
  const auto within = [&](double error) {
    const double part = random.uniform(-1.5, 1.5);
    return error * std::clamp(part, -1.0, 1.0);
  };
  SluggishBase base;
  base.lag = std::max(0.0, model.time_constant + within(model.time_constant_error));
  base.dead_time = std::max(0.0, model.dead_time + within(model.dead_time_error));
  base.deadband = model.deadband, base.quantum = model.quantum;
  return base;
}

// One base on a reference that is driven as badly as its limits allow.
void drive(const ExecutionModel& model, const Planner& planner, const Robot& limits,
           test::Random& random, int steps, Worst& worst) {
  ReferenceTracker tracker(model, planner);
  SluggishBase base = base_of(model, random);
  Adversary adversary{test::Random(static_cast<std::uint64_t>(random.uniform(0, 1e9)))};
  Robot body = limits;
  const double dt = planner.options().time_step;
  for (int k = 0; k < steps; ++k) {
    const double wrong = k == 0 ? 0.0 : 1.0;  // at rest the body is known
    body.position = base.position + wrong * model.measured_position_error * adversary.towards;
    body.velocity = base.velocity + wrong * model.measured_velocity_error * adversary.towards;
    const Robot now = tracker.reference(body);
    Vec2 a = adversary.acceleration(base.position - now.position, change_limit(limits));
    Vec2 next = now.velocity + dt * a;
    if (norm(next) > limits.max_speed) next = now.velocity, a = {};
    Plan plan;
    plan.new_velocity = now.velocity + (1.0 / planner.step_rate()) * (next - now.velocity);
    const BaseCommand command = tracker.follow(body, plan);
    ASSERT_FALSE(command.has_left) << k << ": " << command.deviation;
    worst.command = std::max(worst.command, norm(command.velocity));
    base.tell(command.velocity);
    if (random.uniform(0, 1) < 0.3)
      base.error =
          model.velocity_error * (random.uniform(0, 1) < 0.5 ? -1.0 : 1.0) * adversary.towards;
    base.move(dt, kParts, [&](double part) {
      const double t = part * dt;
      const Vec2 p = now.position + t * now.velocity + (0.5 * t * t) * a;
      worst.position = std::max(worst.position, norm(base.position - p));
      worst.velocity = std::max(worst.velocity, norm(base.velocity - (now.velocity + t * a)));
    });
  }
}

Robot robot_of(double change, double speed) {
  Robot robot;
  robot.max_acceleration = change, robot.max_speed = speed;
  return robot;
}

Worst worst_of(const ExecutionModel& model, const Planner& planner, const Robot& limits, int runs,
               std::uint64_t seed) {
  test::Random random(seed);
  Worst worst;
  for (int run = 0; run < runs && !::testing::Test::HasFatalFailure(); ++run)
    drive(model, planner, limits, random, 400, worst);
  return worst;
}

ExecutionModel random_model(test::Random& random, double time_step) {
  const auto some = [&](double most) { return std::max(0.0, random.uniform(-0.5, 1.0) * most); };
  ExecutionModel model;
  model.time_constant = some(0.5), model.dead_time = some(2.5 * time_step);
  model.time_constant_error = std::min(0.2 * model.time_constant, some(0.1));
  model.dead_time_error = std::min(some(0.15 * time_step), model.dead_time);
  model.deadband = some(0.1), model.quantum = some(0.05), model.velocity_error = some(0.05);
  model.measured_position_error = some(0.01), model.measured_velocity_error = some(0.05);
  return model;
}

TEST(BaseExecution, base_stays_within_the_bounds_of_its_declaration) {
  test::Random random(7);
  Worst largest;
  for (int k = 0; k < 300 && !HasFatalFailure(); ++k) {
    PlannerOptions options;
    options.time_step = random.uniform(0.03, 0.2);
    options.control_time = std::max(options.control_time, options.time_step);
    const Planner planner(options);
    const Robot limits = robot_of(random.uniform(0.3, 3.0), random.uniform(0.3, 2.0));
    const ExecutionModel model = random_model(random, options.time_step);
    const ExecutionError most = execution_error(model, limits, options.time_step);
    const Worst worst = worst_of(model, planner, limits, 4, 100 + k);
    EXPECT_LE(worst.position, (1.0 + 1e-9) * most.position) << k;
    EXPECT_LE(worst.velocity, (1.0 + 1e-9) * most.velocity) << k;
    EXPECT_LE(worst.command, (1.0 + 1e-9) * most.command) << k;
    largest.position = std::max(largest.position, worst.position / most.position);
    largest.velocity = std::max(largest.velocity, worst.velocity / most.velocity);
    largest.command = std::max(largest.command, worst.command / most.command);
  }
  RecordProperty("position", std::to_string(largest.position));
  RecordProperty("velocity", std::to_string(largest.velocity));
  RecordProperty("command", std::to_string(largest.command));
  EXPECT_GT(largest.position, 0.9);
}

// Without its term, a bound is broken by a base that has the fault alone.
TEST(BaseExecution, no_term_can_be_left_out) {
  const PlannerOptions options;
  const Planner planner(options);
  const Robot limits = robot_of(1.0, 1.5);
  const auto expect_needed = [&](const char* name, ExecutionModel model, ExecutionModel without) {
    const ExecutionError most = execution_error(model, limits, options.time_step);
    const ExecutionError less = execution_error(without, limits, options.time_step);
    const Worst worst = worst_of(model, planner, limits, 40, 3);
    EXPECT_LE(worst.position, (1.0 + 1e-9) * most.position) << name;
    EXPECT_GT(worst.position, less.position) << name;
    RecordProperty(name, std::to_string(worst.position / most.position));
  };
  expect_needed("time_constant_error", {.time_constant = 0.3, .time_constant_error = 0.06},
                {.time_constant = 0.3});
  expect_needed("dead_time", {.dead_time = 0.1}, {});
  expect_needed("dead_time_beside_a_lag", {.time_constant = 0.3, .dead_time = 0.1},
                {.dead_time = 0.1});
  expect_needed("dead_time_error",
                {.time_constant = 0.3, .dead_time = 0.02, .dead_time_error = 0.02},
                {.time_constant = 0.3, .dead_time = 0.02});
  expect_needed("deadband", {.deadband = 0.1}, {});
  expect_needed("quantum", {.quantum = 0.1}, {});
  expect_needed("velocity_error", {.velocity_error = 0.05}, {});
  expect_needed("measured_position_error", {.measured_position_error = 0.01}, {});
  expect_needed("measured_velocity_error", {.time_constant = 0.3, .measured_velocity_error = 0.03},
                {.time_constant = 0.3});
}

TEST(BaseExecution, exact_base_is_commanded_as_decided) {
  const Planner planner{PlannerOptions{}};
  ReferenceTracker tracker({}, planner);
  const Robot body{.velocity = {1.0, 0.0}, .preferred_velocity = {0.0, 1.5}};
  PlanWorkspace workspace;
  const Plan plan = planner.plan(tracker.reference(body), {}, workspace);
  const BaseCommand command = tracker.follow(body, plan);
  const Vec2 mean = 0.5 * (body.velocity + plan.next_velocity);
  EXPECT_NEAR(norm(command.velocity - mean), 0.0, 1e-12);
  EXPECT_NEAR(norm(command.next_reference - 0.1 * mean), 0.0, 1e-12);
  EXPECT_EQ(command.next_velocity, plan.next_velocity);
}

TEST(BaseExecution, body_that_was_moved_by_hand_is_told_and_begins_anew) {
  const ExecutionModel model{.dead_time = 0.1};
  const Planner planner{PlannerOptions{}};
  ReferenceTracker tracker(model, planner);
  Robot body;
  const double most = execution_error(model, body, 0.1).position;
  EXPECT_EQ(tracker.reference(body).radius, body.radius + most);
  EXPECT_FALSE(tracker.follow(body, {}).has_left);
  body.position = {0.9 * most, 0.0};
  EXPECT_EQ(tracker.reference(body).position, Vec2{});
  EXPECT_FALSE(tracker.follow(body, {}).has_left);
  body.position = {1.1 * most, 0.0};
  EXPECT_EQ(tracker.reference(body).position, body.position);
  const BaseCommand command = tracker.follow(body, {});
  EXPECT_TRUE(command.has_left);
  EXPECT_NEAR(command.deviation, 1.1 * most, 1e-12);
  EXPECT_FALSE(tracker.follow(body, {}).has_left);
}

// The coordinate that is sent is the nearest one that the base executes.
TEST(BaseExecution, commands_are_those_that_the_base_executes) {
  test::Random random(2);
  const Planner planner{PlannerOptions{}};
  for (int k = 0; k < 2000; ++k) {
    ExecutionModel model;
    model.deadband = std::max(0.0, random.uniform(-0.1, 0.2));
    model.quantum = std::max(0.0, random.uniform(-0.1, 0.1));
    ReferenceTracker tracker(model, planner);
    Robot body;
    body.velocity = {random.uniform(-0.3, 0.3), 0.0};
    Plan plan;
    plan.new_velocity = body.velocity;
    const double sent = tracker.follow(body, plan).velocity.x;
    const double q = model.quantum, wanted = body.velocity.x;
    if (q > 0.0) {
      EXPECT_NEAR(sent / q, std::round(sent / q), 1e-9);
    }
    EXPECT_TRUE(sent == 0.0 || std::abs(sent) >= model.deadband) << sent;
    const double least = q > 0.0 ? q * std::ceil(model.deadband / q - 1e-9) : model.deadband;
    EXPECT_LE(std::abs(sent - wanted), 0.5 * std::max(least, q) + 1e-9);
  }
}

// The table of docs/on_board.md, "Bases that do not execute exactly".
TEST(BaseExecution, table_of_on_board) {
  const Robot base = robot_of(1.0, 1.0);
  Robot drive = robot_of(0.5, 0.5);
  drive.model =
      DifferentialDrive{.track = 0.4, .offset = 0.2, .wheel_speed = 0.9, .wheel_acceleration = 2.0};
  const auto expect_row = [](const ExecutionModel& model, const Robot& robot, double position,
                             double velocity, double command) {
    const ExecutionError found = execution_error(model, robot, 0.1);
    EXPECT_NEAR(found.position, position, 0.00006);
    EXPECT_NEAR(found.velocity, velocity, 0.006);
    EXPECT_NEAR(found.command, command, 0.006);
  };
  expect_row({}, base, 0.0013, 0.05, 1.0);
  expect_row({.quantum = 0.01}, base, 0.0020, 0.06, 1.01);
  expect_row({.deadband = 0.05}, base, 0.0048, 0.12, 1.07);
  expect_row({.velocity_error = 0.02}, base, 0.0033, 0.09, 1.02);
  expect_row({.measured_position_error = 0.002}, base, 0.0033, 0.09, 1.04);
  expect_row({.time_constant = 0.2}, base, 0.0013, 0.01, 1.2);
  expect_row({.time_constant = 0.2, .time_constant_error = 0.02}, base, 0.0058, 0.06, 1.25);
  expect_row({.dead_time = 0.1}, base, 0.0063, 0.25, 1.1);
  expect_row({.dead_time = 0.1, .dead_time_error = 0.01}, base, 0.0162, 0.31, 1.15);
  expect_row({.time_constant = 0.2, .dead_time = 0.05, .deadband = 0.03, .quantum = 0.01}, base,
             0.0146, 0.15, 1.29);
  expect_row({.time_constant = 0.08,
              .dead_time = 0.06,
              .deadband = 0.03,
              .quantum = 0.01,
              .heading_age = 0.01},
             drive, 0.0219, 0.31, 1.34);
}

void expect_refusal(const ExecutionModel& model, const std::string& words) {
  try {
    (void)execution_error(model, {}, 0.1);
    ADD_FAILURE() << words;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(BaseExecution, values_out_of_range_are_refused_by_name) {
  expect_refusal({.time_constant = -1}, "ExecutionModel.time_constant: found -1, must be >= 0 s");
  expect_refusal({.time_constant = 0.1, .time_constant_error = 0.2},
                 "ExecutionModel.time_constant_error: found 0.2, must be <= 0.1 s");
  expect_refusal({.dead_time = 101}, "ExecutionModel.dead_time: found 101, must be <= 100 s");
  expect_refusal({.deadband = -0.1}, "ExecutionModel.deadband: found -0.1, must be >= 0 m/s");
  expect_refusal({.time_constant = 0.06, .time_constant_error = 0.06},
                 "2 time_constant_error/max(time_step, time_constant - time_constant_error) = 1.2, "
                 "must be < 1");
  Robot car;
  car.model = Car{};
  EXPECT_THROW((void)execution_error({}, car, 0.1), Error);
  PlannerOptions exponential;
  exponential.motion = Motion::exponential;
  EXPECT_THROW(ReferenceTracker({}, Planner(exponential)), Error);
}

}  // namespace
}  // namespace avo
