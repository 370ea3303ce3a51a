// SPDX-License-Identifier: Apache-2.0
// What errors and neighbors that do not decide take off the constraints of a pair, in the plane and
// in space.
#pragma once
#include <array>
#include <cstddef>

#include "certificate/allow_braking.h"
#include "certificate/constraint_columns.h"
#include "certificate/pair_constraints.h"

namespace avo::inline certificate {

/// The error of the path of a body that is sensed in motion for `time`, m.
inline double error_at(const StepLaw& law, double time) {
  return law.sensing_error.position + law.sensing_error.velocity * time;
}

/// Subtracts the errors and the effects of movers from the pair's constraints, the last ones from
/// `first` on.
template <int D, typename Constraints>
void take_off(const PairConstraintsOf<D>& wanted, std::size_t first, const StepLaw& law,
              Constraints& constraints) {
  ConstraintColumnsOf<D>& columns = constraints.columns;
  const std::array<double, 3> times{0.0, law.lag, law.time_step};
  for (std::size_t k = first; k < columns.count; ++k) {
    if (!columns.is_constraint(k)) continue;
    const double m = columns.interval[k];
    const bool holds = m < wanted.moving;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!holds) columns.offset[i][k] -= error_at(law, m * law.time_step + times[i]);
    }
    if (columns.cone[k] > 0.0) {
      constraints.has_cones = true;
      if (!wanted.is_free) allow_braking(wanted.pair.a, law, columns, k);
    }
    if (holds || m > 0.0) continue;
    // The start of A cannot be inflated: A could then never leave a place at rest beside a mover.
    for (std::size_t i = 0; i < 2; ++i) {
      columns.offset[i][k] +=
          wanted.held - (wanted.inflated - wanted.pair.inflated) - wanted.pair.contact;
      if (!(columns.offset[i][k] >= 0.0)) constraints.stays_at_rest = true;
    }
  }
}

}  // namespace avo::inline certificate
