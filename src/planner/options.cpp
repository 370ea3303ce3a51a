// SPDX-License-Identifier: Apache-2.0
// Options of a planner: what is customary, what is possible, and what they are called.
#include "planner/options.h"

#include <string>

#include "core/ranges.h"

namespace avo {
namespace {

constexpr const char* kPrefix = "PlannerOptions.";

[[noreturn]] void refuse(const char* name, const std::string& given, const std::string& allowed) {
  avo::refuse(std::string(kPrefix) + name, given, allowed);
}

void require(const char* name, double value, const Range& range, const char* unit) {
  avo::require(std::string(kPrefix) + name, value, range, unit);
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
  require("sensing_error.position", options.sensing_error.position, kNotNegative, "m");
  require("sensing_error.velocity", options.sensing_error.velocity, kNotNegative, "m/s");
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
  require("arrival_distance", options.arrival_distance, kPositive, "m");
  validate_sensing_error(options);
}

}  // namespace

const char* to_string(Method method) {
  return name_of(method);
}
const char* to_string(Certificate certificate) {
  return name_of(certificate);
}
const char* to_string(Motion motion) {
  return name_of(motion);
}
const char* to_string(PlanStatus status) {
  return name_of(status);
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
  require("control_time", options.control_time, kPositive, "s");
  require("time_horizon", options.time_horizon, kPositive, "s");
  require("time_step", options.time_step, kPositive, "s");
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
