// SPDX-License-Identifier: Apache-2.0
// How long a robot would take if it were alone (docs/metrics.md, "Ideal time").
#pragma once

namespace avo::inline metrics {

/// A way from a start to a goal, and what drives along it.
struct IdealTrip {
  double way = 0.0;           // m, >= 0, to the goal; may be infinite
  double margin = 0.0;        // m, >= 0: it has arrived so far before the goal
  double speed = 0.0;         // m/s, along the way at the start; negative: away from it
  double top_speed = 0.0;     // m/s, >= 0, that it strives for
  double acceleration = 0.0;  // m/s^2, > 0
  bool stops = true;          // at the goal; else it passes
};

/// s, of the trapezoidal profile: to the top speed at full acceleration, on at it, and with full
/// braking so that it comes to rest at the goal; up to where it has arrived. Infinite where the way
/// or nothing of the speed is.
double ideal_time(const IdealTrip& trip);

}  // namespace avo::inline metrics
