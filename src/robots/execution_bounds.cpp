// SPDX-License-Identifier: Apache-2.0
#include "robots/execution_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "avo/error.h"
#include "core/ranges.h"
#include "robots/ahead.h"

namespace avo::inline robots {
namespace {

constexpr double kMostDeadSteps = 1000.0;
constexpr double kWheelRounding = 1e-9;  // of wheels' speeds that are computed from two others
constexpr int kMostIterations = 1000;
constexpr double kGrowth = 0x1p-20;  // of an iterate, beyond what is needed: so that it ends

// m/s: the least coordinate that moves the base, 0 without a deadband.
double least_speed(const ExecutionModel& model) {
  if (model.quantum == 0.0) return (1.0 + kWheelRounding) * model.deadband;
  double steps = std::ceil(model.deadband / model.quantum);
  if (steps * model.quantum < model.deadband) ++steps;  // the quotient was rounded
  return steps * model.quantum;
}

// [κ, ψ] How much of a bound comes back by an uncertain T and d: of itself, in a step.
struct Feedback {
  double by_time_constant, by_dead_time;
  [[nodiscard]] double sum() const { return by_time_constant + by_dead_time; }
};

Feedback feedback_of(const ExecutionModel& model, double time_step) {
  const double least_lag = model.time_constant - model.time_constant_error;
  return {2.0 * model.time_constant_error / std::max(time_step, least_lag),
          2.0 * model.dead_time_error / time_step};
}

}  // namespace

double executable(const ExecutionModel& model, double wanted) {
  const double q = model.quantum, least = least_speed(model);
  const double nearest = q > 0.0 ? q * std::round(wanted / q) : wanted;
  if (std::abs(nearest) >= least) return nearest;
  return std::abs(wanted) > 0.5 * least ? std::copysign(least, wanted) : 0.0;
}

namespace {

// m/s: the largest distance of a coordinate from the nearest executable one.
double rounding_of(const ExecutionModel& model) {
  return 0.5 * std::max(least_speed(model), model.quantum);
}

// [μ/Δt] m/s: what a command is wrong by, because the body is measured so badly.
double noise_of(const ExecutionModel& model, double time_step) {
  return (model.measured_position_error + model.time_constant * model.measured_velocity_error) /
         time_step;
}

// [g] m/s: what a command of a holonomic base may be wrong by.
double command_error(const ExecutionModel& model, double time_step) {
  return std::numbers::sqrt2 * rounding_of(model) + noise_of(model, time_step);
}

struct Bounds {
  ExecutionError error;
  double lag;  // [Y] m/s, of the velocity's distance from the late reference's
};

// g, e: m/s, what a command may be wrong by, and the error of the executed velocity. The names
// are those of docs/certificate/execution.md, "The bounds".
Bounds bounds_with(const ExecutionModel& model, const ExecutionLimits& limits, double dt, double g,
                   double e) {
  const double c = limits.change, T = model.time_constant, d = model.dead_time;
  const double lag_error = model.time_constant_error, dead_error = model.dead_time_error;
  const Feedback back = feedback_of(model, dt);
  const double kappa = back.by_time_constant, psi = back.by_dead_time;
  const double late = 0.5 * dt + d + lag_error, window = dt + d;
  const double X = (2.0 * g + e + c * lag_error + kappa * (c * late + e) + psi * c * (dt + T + d)) /
                   (1.0 - back.sum());
  const double Y = c * late + X + e;
  const double by_lag =
      lag_error > 0.0 ? lag_error * (c * window + 2.0 * Y * std::min(2.0, window / (T - lag_error)))
                      : 0.0;
  const double by_shift = dead_error * (c * (3.0 * dt + d + 4.0 * (T + d)) + 4.0 * X);
  const double position =
      dt * g + e * window + by_lag + by_shift + c * (0.125 * dt * dt + 0.5 * d * d + T * d);
  const double velocity = Y + c * (d + dead_error);
  return {{.position = position,
           .velocity = T > 0.0 ? std::min(velocity, 2.0 * position / T) : velocity,
           .command = limits.speed + c * (T + d) + X},
          Y};
}

// [e'] m/s: what the wheels of a drive make of the velocity error, with such bounds.
double error_by_wheels(const ExecutionModel& model, const DifferentialDrive& drive,
                       const ExecutionLimits& limits, const Bounds& bounds) {
  const double T = model.time_constant, lag_error = model.time_constant_error;
  const double wrong = model.measured_velocity_error, h = model.heading_age;
  const double V = limits.speed + bounds.error.velocity, turning = V / drive.offset;
  const double swerve =
      T > 0.0 ? 2.0 * T * (limits.change + V * turning + 2.0 * bounds.lag / (T - lag_error)) : 0.0;
  const double aged = h > 0.0 ? h * (bounds.error.command + swerve) : 0.0;
  return model.velocity_error +
         rounding_of(model) * std::max(1.0, 2.0 * drive.offset / drive.track) +
         turning * (V * lag_error + aged) + T * wrong * (2.0 * V + wrong) / drive.offset;
}

// For a drive, with the errors of its wheels.
struct DriveBounds {
  Bounds bounds;
  double error;  // [e'] m/s, of the velocity
};

// e' grows with the bounds that it makes larger: the least solution, from below.
DriveBounds bounds_of_drive(const ExecutionModel& model, const DifferentialDrive& drive,
                            const ExecutionLimits& limits, double time_step) {
  double e = model.velocity_error;
  for (int round = 0; round < kMostIterations; ++round) {
    Bounds bounds = bounds_with(model, limits, time_step, noise_of(model, time_step), e);
    const double needed = error_by_wheels(model, drive, limits, bounds);
    if (needed <= e) {
      const double V = limits.speed + bounds.error.velocity + model.measured_velocity_error;
      const double k = 0.5 * drive.track / drive.offset, lag = model.time_constant;
      bounds.error.command =
          std::sqrt(1.0 + k * k) * (bounds.error.command + lag * V * V / drive.offset);
      return {bounds, e};
    }
    if (needed > kLargest) break;
    e = (1.0 + kGrowth) * needed;
  }
  throw Error(
      "ExecutionModel: found no bound for a drive that turns that fast: heading_age and "
      "time_constant_error must be shorter");
}

}  // namespace

ExecutionError bounds_of(const ExecutionModel& model, const MotionModel& robot,
                         const ExecutionLimits& limits, double time_step) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&robot))
    return bounds_of_drive(model, *drive, limits, time_step).bounds.error;
  if (!is_holonomic(robot))
    throw Error(
        "ExecutionModel: found a car or an airplane, must be a holonomic robot or a "
        "differential drive");
  return bounds_with(model, limits, time_step, command_error(model, time_step),
                     model.velocity_error)
      .error;
}

namespace {

// The same as below, with the velocity error of the wheels.
double off_cubic_of_drive(const ExecutionModel& model, const DifferentialDrive& drive,
                          const ExecutionLimits& limits, double time_step) {
  const DriveBounds of = bounds_of_drive(model, drive, limits, time_step);
  const double Y = of.bounds.lag, c = limits.change;
  const double lag = model.time_constant - model.time_constant_error;
  if (lag > 0.0) return time_step * time_step * (c + 2.0 * Y / lag) / 16.0;
  // without a lag q has the velocity of the command, and e'
  const double variation = 2.0 * (2.0 * (Y + of.error) + c * time_step);
  return time_step * (4.0 / 27.0 * variation + (0.5 + 8.0 / 27.0) * of.error);
}

}  // namespace

// With e = 0 at both ends, |e(t)| is at most 1/16 of Δt² times the largest |e''|, and 4/27 of Δt
// times the variation of the velocity.
double off_cubic(const ExecutionModel& model, const MotionModel& robot,
                 const ExecutionLimits& limits, double time_step) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&robot))
    return off_cubic_of_drive(model, *drive, limits, time_step);
  const double Y =
      bounds_with(model, limits, time_step, command_error(model, time_step), model.velocity_error)
          .lag;
  const double c = limits.change, lag = model.time_constant - model.time_constant_error;
  const double variation = 2.0 * (2.0 * Y + c * time_step);  // m/s, of both parts of a step
  const double by_variation = 4.0 / 27.0 * time_step * variation;
  if (!(lag > 0.0)) return by_variation;
  return std::min(by_variation, time_step * time_step * (c + 2.0 * Y / lag) / 16.0);
}

Vec2 still_to_come(std::span<const Vec2> sent, std::size_t next, double dead_time,
                   double time_step) {
  Vec2 sum = {};
  double left = dead_time;
  for (std::size_t k = 1; k <= sent.size() && left > 0.0; ++k, left -= time_step)
    sum = sum + std::min(left, time_step) * sent[(next + sent.size() - k) % sent.size()];
  return sum;
}

Vec2 command_towards(const ExecutionModel& model, const MotionState& after, Vec2 position,
                     Vec2 velocity, Vec2 still_to_come, double time_step) {
  const double lead = model.time_constant + model.dead_time;
  const Vec2 target = after.position + lead * after.velocity;
  const Vec2 expected = position + model.time_constant * velocity + still_to_come;
  return (1.0 / time_step) * (target - expected);
}

void validate(const ExecutionModel& model, double time_step, const std::string& prefix) {
  const auto at = [&](const char* name) { return prefix + name; };
  require("time_step", time_step, kPositive, "s");
  require(at("time_constant"), model.time_constant, kNotNegative, "s");
  require(at("time_constant_error"), model.time_constant_error,
          Range{0.0, model.time_constant, false}, "s");
  require(at("dead_time"), model.dead_time, Range{0.0, kMostDeadSteps * time_step, false}, "s");
  require(at("dead_time_error"), model.dead_time_error, Range{0.0, model.dead_time, false}, "s");
  require(at("deadband"), model.deadband, kNotNegative, "m/s");
  require(at("quantum"), model.quantum, kNotNegative, "m/s");
  require(at("velocity_error"), model.velocity_error, kNotNegative, "m/s");
  require(at("heading_age"), model.heading_age, kNotNegative, "s");
  require(at("measured_position_error"), model.measured_position_error, kNotNegative, "m");
  require(at("measured_velocity_error"), model.measured_velocity_error, kNotNegative, "m/s");
  const double back = feedback_of(model, time_step).sum();
  if (back < 1.0) return;
  const std::string steps = model.dead_time_error > 0.0 ? " + 2 dead_time_error/time_step" : "";
  refuse(at("time_constant_error"),
         "2 time_constant_error/max(time_step, time_constant - time_constant_error)" + steps +
             " = " + text(back),
         "< 1");
}

}  // namespace avo::inline robots

namespace avo {

ExecutionError execution_error(const ExecutionModel& model, const Robot& robot, double time_step) {
  validate(model, time_step);
  require("Robot.max_acceleration", robot.max_acceleration, kPositive, "m/s^2");
  require("Robot.max_braking", braking_limit(robot), kPositive, "m/s^2");
  require("Robot.max_speed", robot.max_speed, kPositive, "m/s");
  return bounds_of(model, robot.model, limits_of(robot), time_step);
}

// From T du/dt = U - u in the frame of the robot it follows for q that T q'' + q' = U + T ω J q',
// where J turns by a right angle to the left. The command U leaves w on the right.
DriveCommand drive_command(const ExecutionModel& model, const Robot& body, Vec2 velocity) {
  const auto* drive = std::get_if<DifferentialDrive>(&body.model);
  if (drive == nullptr)
    throw Error("drive_command: robot: found another model, must be a differential drive");
  const Vec2 h = ahead_of(body.heading);
  const double v = dot(h, body.velocity), across = cross(h, body.velocity);
  const double T = model.time_constant, turning = across / drive->offset;
  const double speed = dot(h, velocity) + T * turning * across;
  const double to_wheel =
      0.5 * drive->track * (cross(h, velocity) - T * turning * v) / drive->offset;
  const double left = executable(model, speed - to_wheel);
  const double right = executable(model, speed + to_wheel);
  return {0.5 * (left + right), (right - left) / drive->track};
}

}  // namespace avo
