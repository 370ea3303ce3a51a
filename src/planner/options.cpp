// SPDX-License-Identifier: Apache-2.0
// Options of a planner: what is customary, what is possible, and what they are called.
#include "planner/options.h"

#include <string>

#include "avo/error.h"
#include "core/ranges.h"

namespace avo {
namespace {

[[noreturn]] void refuse(const char* name, const std::string& given, const std::string& allowed) {
  throw Error(std::string("PlannerOptions.") + name + ": found " + given + ", must be " + allowed);
}

void require_positive(double value, const char* name, const char* allowed = "> 0 s") {
  if (kPositive.contains(value)) return;
  refuse(name, text(value), value > kLargest ? "<= " + text(kLargest) : allowed);
}

void validate_control(const PlannerOptions& options) {
  const bool held = options.motion == Motion::held;
  if (held && options.time_step > options.control_time) {
    refuse("time_step", text(options.time_step), "<= control_time where motion is held");
  }
  if (options.control_time < kShortestControl) {
    refuse("control_time", text(options.control_time), ">= " + text(kShortestControl) + " s");
  }
  if (!held && options.time_step > kMostControlTimes * options.control_time) {
    refuse("control_time", text(options.control_time),
           ">= time_step / " + text(kMostControlTimes) + " where motion is exponential");
  }
}

void validate_sensing_error(const PlannerOptions& options) {
  const auto require = [](double value, const char* name, const char* unit) {
    if (kNotNegative.contains(value)) return;
    refuse(name, text(value), value > kLargest ? "<= " + text(kLargest) : unit);
  };
  require(options.sensing_error.position, "sensing_error.position", ">= 0 m");
  require(options.sensing_error.velocity, "sensing_error.velocity", ">= 0 m/s");
  if (options.sensing_error != SensingError{} &&
      options.certificate != Certificate::braking_trajectories) {
    refuse("sensing_error", "one",
           std::string("none with certificate ") + to_string(options.certificate));
  }
}

void validate_certificate(const PlannerOptions& options) {
  if (options.certificate != Certificate::none && options.method != Method::avo) {
    refuse("certificate", to_string(options.certificate),
           std::string("none with method ") + to_string(options.method));
  }
  require_positive(options.arrival_distance, "arrival_distance", "> 0 m");
  validate_sensing_error(options);
}

}  // namespace

const char* to_string(Method method) {
  switch (method) {
    case Method::avo:
      return "avo";
    case Method::avo_paper:
      return "avo_paper";
    case Method::velocity_obstacle:
      return "velocity_obstacle";
    case Method::orca:
      return "orca";
  }
  return "unknown";
}

const char* to_string(Certificate certificate) {
  switch (certificate) {
    case Certificate::none:
      return "none";
    case Certificate::stopping_capsules:
      return "stopping_capsules";
    case Certificate::braking_trajectories:
      return "braking_trajectories";
  }
  return "unknown";
}

const char* to_string(Motion motion) {
  return motion == Motion::held ? "held" : "exponential";
}

PlannerOptions default_options(Method method) {
  PlannerOptions options;
  options.method = method;
  if (method == Method::avo) return options;
  options.control_time = 4.0;
  options.time_horizon = 10.0;
  options.certificate = Certificate::none;
  return options;
}

void validate(const PlannerOptions& options) {
  require_positive(options.control_time, "control_time");
  require_positive(options.time_horizon, "time_horizon");
  require_positive(options.time_step, "time_step");
  if (options.time_step > options.time_horizon) {
    refuse("time_step", text(options.time_step), "<= time_horizon");
  }
  if (!adopts_at_once(options.method)) validate_control(options);
  if (!kSamples.contains(options.samples) || options.samples == 1) {
    refuse("samples", std::to_string(options.samples), "0 (exact) or 2 to 1000");
  }
  if (options.max_neighbors && *options.max_neighbors < 1) {
    refuse("max_neighbors", std::to_string(*options.max_neighbors), ">= 1");
  }
  validate_certificate(options);
}

}  // namespace avo
