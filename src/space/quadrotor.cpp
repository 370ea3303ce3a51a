// SPDX-License-Identifier: Apache-2.0
#include "avo/space/quadrotor.h"

#include <algorithm>

#include "core/elementary.h"
#include "core/ranges.h"
#include "fields/space_fields.h"

namespace avo::space {
namespace {

constexpr double kGravity = 9.80665;  // m/s^2
// The rest of thrust and tilt is for feedback, against wind and the vehicle's own errors.
constexpr double kReserve = 0.8;
constexpr double kMinThrust = 0.1;  // of the weight

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
  require_ranges(quadrotor, Behind{name + "."});
  const double weight = kGravity * quadrotor.mass;
  if (!(quadrotor.max_thrust > weight))
    refuse(name + ".max_thrust", text(quadrotor.max_thrust),
           "> " + text(weight) + " N, the weight of its mass");
  if (!(min_thrust(quadrotor) < weight))
    refuse(name + ".min_thrust", text(min_thrust(quadrotor)),
           "< " + text(weight) + " N, the weight of its mass");
}

}  // namespace avo::space
