// SPDX-License-Identifier: Apache-2.0
#include "metrics/voronoi.h"

#include <cmath>
#include <utility>

namespace avo::inline metrics {

void VoronoiCell::begin() {
  const double half = 0.5 * kCellRadius, rise = std::sqrt(3.0) * half;
  corners.assign({{kCellRadius, 0.0}, {rise, half}, {half, rise}});
  for (std::size_t k = 0; k < 9; ++k) corners.push_back(perpendicular(corners[k]));
}

// Keeps the side of the bisector on which the origin lies: other·x <= |other|²/2.
void VoronoiCell::cut(Vec2 other) {
  const double offset = 0.5 * norm_squared(other);
  if (!(offset > 0.0)) return;
  scratch.clear();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 from = corners[k], to = corners[k + 1 < corners.size() ? k + 1 : 0];
    const double before = offset - dot(other, from), after = offset - dot(other, to);
    if (before >= 0.0) scratch.push_back(from);
    if ((before >= 0.0) != (after >= 0.0))
      scratch.push_back(from + (before / (before - after)) * (to - from));
  }
  std::swap(corners, scratch);
}

double VoronoiCell::area() const {
  double twice = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k)
    twice += cross(corners[k], corners[k + 1 < corners.size() ? k + 1 : 0]);
  return 0.5 * twice;
}

}  // namespace avo::inline metrics
