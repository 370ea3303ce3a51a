// SPDX-License-Identifier: Apache-2.0
// How near two bodies come over one step, and when, by isolating the roots of d/du |x(u)|².
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "avo/vec.h"

namespace avo::judge {

/// One body relative to another over a step: a cubic by its Bézier control points, m. The fraction
/// u of the step runs from 0 to 1.
struct RelativePath {
  std::array<Vec2, 4> control;
};

/// Returns the value at u of a polynomial by its coefficients in Bernstein form.
template <std::size_t N>
double value_at(std::array<double, N> b, double u) {
  for (std::size_t n = N - 1; n > 0; --n)
    for (std::size_t k = 0; k < n; ++k) b[k] = (1.0 - u) * b[k] + u * b[k + 1];
  return b[0];
}

struct Instant {
  double fraction = 0.0;  // of the step
  double distance = 0.0;  // m
};

/// The first instant at which the two are nearest: to 1e-13 of the path's largest distance.
Instant nearest_instant(const RelativePath& path);

/// First and last fraction of the step at which the distance is less than `limit` >= 0; none where
/// it never is.
std::optional<double> first_below(const RelativePath& path, double limit);
std::optional<double> last_below(const RelativePath& path, double limit);

/// No point of the path is nearer than this; it takes little time, and is far from sharp.
double lower_bound(const RelativePath& path);

}  // namespace avo::judge
