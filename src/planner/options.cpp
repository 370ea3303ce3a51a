// SPDX-License-Identifier: Apache-2.0
// Options of a planner: usual values, valid ranges, and names.
#include "planner/options.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/ranges.h"
#include "core/response_law_kernel.h"
#include "fields/planner_fields.h"

namespace avo {
namespace {

// Rows and names stand in the order of the methods.
static_assert(kNames<Method>.size() == kMethodTraits.size() &&
              std::all_of(kMethodTraits.begin(), kMethodTraits.end(), [](const MethodTraits& row) {
                return &row == &method_traits(row.method);
              }));

void validate_ranges(const PlannerOptions& options, const std::string& prefix) {
  require_ranges(options, Behind{prefix});
  require_ranges(options.sensing_error, Behind{prefix + "sensing_error."});
  require_ranges(options.sensing_noise, Behind{prefix + "sensing_noise."});
  if (options.wall_range != std::numeric_limits<double>::infinity())
    require(prefix + "wall_range", options.wall_range, kNotNegative, "m");
}

// Checks that motion can follow the response within a step.
void validate_control(const PlannerOptions& options, const std::string& prefix) {
  const double dt = options.time_step, delta = options.control_time;
  const bool held = options.motion == Motion::held;
  // A held acceleration (v' - v)/δ leaves the fraction q = 1 - Δt/δ of the error: q < 0 overshoots.
  if (held && dt > delta)
    refuse(prefix + "time_step", text(dt),
           "<= control_time = " + text(delta) + " s where motion is held");
  if (delta < kShortestControl)
    refuse(prefix + "control_time", text(delta), ">= " + text(kShortestControl) + " s");
  if (!held && dt > kMostControlTimes * delta)
    refuse(prefix + "control_time", text(delta),
           ">= time_step / " + text(kMostControlTimes) + " = " + text(dt / kMostControlTimes) +
               " s where motion is exponential");
}

void validate_comfort(const PlannerOptions& options, const std::string& prefix) {
  if (method_traits(options.method).has_rules) return;
  const std::string others = std::string(" with method ") + to_string(options.method);
  if (options.response_time > 0.0)
    refuse(prefix + "response_time", text(options.response_time), "0" + others);
  if (options.comfort_acceleration)
    refuse(prefix + "comfort_acceleration", text(*options.comfort_acceleration), "none" + others);
  if (options.comfort_jerk)
    refuse(prefix + "comfort_jerk", text(*options.comfort_jerk), "none" + others);
  if (options.margin > 0.0) refuse(prefix + "margin", text(options.margin), "0 m" + others);
  if (options.never_swerves) refuse(prefix + "never_swerves", "true", "false" + others);
}

void validate_certificate(const PlannerOptions& options, const std::string& prefix) {
  if (options.certificate != Certificate::none && !may_be_certified(options.method))
    refuse(prefix + "certificate", to_string(options.certificate),
           std::string("none with method ") + to_string(options.method));
  if (options.sensing_error != SensingError{} &&
      options.certificate != Certificate::braking_trajectories)
    refuse(prefix + "sensing_error", "one",
           std::string("none with certificate ") + to_string(options.certificate));
  if (options.clock == Clock::common) {
    if (options.longest_step > 0.0)
      refuse(prefix + "longest_step", text(options.longest_step), "0 s where clock is common");
    return;
  }
  if (options.motion != Motion::held)
    refuse(prefix + "clock", to_string(options.clock), "common where motion is exponential");
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
const char* to_string(Clock clock) {
  return name_of(clock);
}
const char* to_string(RightOfWay right_of_way) {
  return name_of(right_of_way);
}
const char* to_string(NoiseDistribution distribution) {
  return name_of(distribution);
}
const char* to_string(Behavior behavior) {
  return name_of(behavior);
}
const char* to_string(PlanStatus status) {
  return name_of(status);
}
const char* to_string(Guide guide) {
  return name_of(guide);
}
const char* to_string(WishRule rule) {
  return name_of(rule);
}
const char* to_string(SafetyState state) {
  return name_of(state);
}

PlannerOptions default_options(Method method) {
  return {.method = method};
}

double response_time_of(const PlannerOptions& options, double max_speed, double max_acceleration) {
  using Real = scalar::Pack<double>;
  const ResponseLaw law = response_law(options);
  if (!law.is_gentle()) return 0.0;
  const Real used = scalar::used_of<Real>(max_acceleration, max_speed, law);
  return scalar::response_time<Real>(max_speed, max_acceleration, used, law).value;
}

}  // namespace avo

namespace avo::inline planner {

void validate(const PlannerOptions& options, const std::string& prefix) {
  validate_ranges(options, prefix);
  if (options.time_step > options.time_horizon)
    refuse(prefix + "time_step", text(options.time_step),
           "<= time_horizon = " + text(options.time_horizon) + " s");
  if (reaches_within_step(options.method)) {
    if (options.motion != Motion::held)
      refuse(prefix + "motion", to_string(options.motion),
             std::string("held with method ") + to_string(options.method));
  } else if (!adopts_at_once(options.method)) {
    validate_control(options, prefix);
  }
  validate_comfort(options, prefix);
  validate_certificate(options, prefix);
}

}  // namespace avo::inline planner
