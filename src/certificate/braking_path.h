// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps: the motion that every robot can fall back on, known to all.
#pragma once
#include <span>
#include <vector>

#include "avo/vec.h"

namespace avo {

/// What the certificates need to know of one step: from v to v_1 it moves by s v + (Δt - s) v_1,
/// inside the triangle of its ends and p + s v, and takes off u = a_max · braking_time at most.
struct StepLaw {
  double time_step = 0.1;     ///< [Δt] s
  double lag = 0.05;          ///< [s] s: Δt/2 (held), s(Δt) (exponential)
  double braking_time = 0.1;  ///< s: Δt (held), δ (1 - e^{-Δt/δ}) (exponential)
};

/// [u] m/s that one step of full braking takes off.
inline double braking_decrement(const StepLaw& law, double max_acceleration) {
  return max_acceleration * law.braking_time;
}

/// Steps that braking from `speed` takes until rest: ⌈speed / u⌉, one more where rounding could
/// tell otherwise.
double braking_steps(double speed, double decrement);

/// [l] m until rest, by steps of `decrement` and a last one of what is left. Not v²/2a: a robot
/// that moves in steps needs up to u Δt/8 more. Exact to a few ulp, any speed >= 0.
double stopping_length(double speed, double decrement, const StepLaw& law);

/// Distances along a braking path, by interval between steps: where it begins, its middle Bézier
/// point, where it ends. All are nondecreasing; at rest all are equal.
struct BrakingDistances {
  std::vector<double> start, middle, end;  ///< m

  /// From `speed` for `intervals` steps. Allocates only while it grows.
  void brake(double speed, double decrement, const StepLaw& law, int intervals);
};

}  // namespace avo
