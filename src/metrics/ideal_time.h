// SPDX-License-Identifier: Apache-2.0
// The duration of a robot's trip if it were alone (docs/metrics.md, "Ideal time").
#pragma once

namespace avo::inline metrics {

/// A route from a start to a goal, and the robot on it.
struct IdealTrip {
  double distance = 0.0;      // m, >= 0, to the goal; may be infinite
  double margin = 0.0;        // m, >= 0: it has arrived at this distance before the goal
  double speed = 0.0;         // m/s, along the route at the start; negative: away from it
  double top_speed = 0.0;     // m/s, >= 0, that it aims for
  double acceleration = 0.0;  // m/s^2, > 0
  bool stops = true;          // at the goal; if false, it passes
};

/// s, of the trapezoidal profile: the robot speeds up to its top speed, keeps it, and brakes in
/// full to come to rest at the goal. The time ends where it has arrived. It is infinite if the
/// route is infinite or the speed is 0.
double ideal_time(const IdealTrip& trip);

}  // namespace avo::inline metrics
