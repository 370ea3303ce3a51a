// SPDX-License-Identifier: Apache-2.0
#include "avo/space/quadrotor.h"

#include <algorithm>

#include "core/elementary.h"
#include "core/ranges.h"

namespace avo::space {
namespace {

constexpr double kGravity = 9.80665;  // m/s^2
// The rest of thrust and tilt is for feedback, against wind and the vehicle's own errors.
constexpr double kReserve = 0.8;
constexpr double kMinThrust = 0.1;    // of the weight
constexpr double kLargestTilt = 1.5;  // rad

double min_thrust(const Quadrotor& quadrotor) {
  return quadrotor.min_thrust.value_or(kMinThrust * kGravity * quadrotor.mass);
}

}  // namespace

// The ball of accelerations a for which the specific force a + g keeps to thrust and tilt.
QuadrotorLimits limits_of(const Quadrotor& quadrotor) {
  const double up = quadrotor.max_thrust / quadrotor.mass - kGravity;
  const double down = kGravity - min_thrust(quadrotor) / quadrotor.mass;
  const double aside = kGravity * elementary::sin(quadrotor.max_tilt);
  const double most = kReserve * std::min({up, down, aside});
  const double delay = quadrotor.attitude_time;
  return {most, quadrotor.tracking_error.value_or(most * delay * delay), delay};
}

void validate(const Quadrotor& quadrotor, const std::string& name) {
  const auto key = [&](const char* what) { return name + "." + what; };
  require(key("mass"), quadrotor.mass, kPositive, "kg");
  require(key("max_thrust"), quadrotor.max_thrust, kPositive, "N");
  require(key("min_thrust"), min_thrust(quadrotor), kNotNegative, "N");
  require(key("max_tilt"), quadrotor.max_tilt, {0.0, kLargestTilt, true}, "rad");
  require(key("attitude_time"), quadrotor.attitude_time, kPositive, "s");
  require(key("tracking_error"), quadrotor.tracking_error.value_or(0.0), kNotNegative, "m");
  const double weight = kGravity * quadrotor.mass;
  if (!(quadrotor.max_thrust > weight))
    refuse(key("max_thrust"), text(quadrotor.max_thrust),
           "> " + text(weight) + " N, the weight of its mass");
  if (!(min_thrust(quadrotor) < weight))
    refuse(key("min_thrust"), text(min_thrust(quadrotor)),
           "< " + text(weight) + " N, the weight of its mass");
}

}  // namespace avo::space
