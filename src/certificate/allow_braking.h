// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "certificate/braking_path.h"
#include "certificate/constraint_columns.h"
#include "certificate/pair.h"

namespace avo::inline certificate {

/// Where braking leaves less than the margin as sensed, A may not lose more of it: changes the
/// constraint k.
template <int D>
void allow_braking(const BrakingOf<D>& own, const StepLaw& law, ConstraintColumnsOf<D>& constraints,
                   std::size_t k) {
  const auto [start, middle, end] =
      braking_distances(own.profile, law, static_cast<int>(constraints.interval[k]));
  VectorOf<D> normal{constraints.normal[0][k], constraints.normal[1][k]};
  if constexpr (D == 3) normal.z = constraints.normal[2][k];
  const double along = dot(normal, own.direction);
  const std::array<double, 3> distances{start, middle, end};
  for (std::size_t i = 0; i < 3; ++i) {
    constraints.offset[i][k] = std::max(constraints.offset[i][k], -distances[i] * along);
  }
}

}  // namespace avo::inline certificate
