// SPDX-License-Identifier: Apache-2.0
// The cell of one point among others: the places that are nearer to it than to any other.
#pragma once
#include <vector>

#include "avo/vec.h"

namespace avo::inline metrics {

/// m, of the regular dodecagon that contains every cell.
inline constexpr double kCellRadius = 2.0;

/// A convex polygon about the point, which is its origin; reuse it and nothing is allocated once
/// it has grown.
struct VoronoiCell {
  std::vector<Vec2> corners = {};  // m, counter-clockwise
  std::vector<Vec2> scratch = {};

  void begin();          ///< sets the whole dodecagon
  void cut(Vec2 other);  ///< m, position of another point; a point at the origin cuts nothing
  [[nodiscard]] double area() const;  ///< m^2
};

}  // namespace avo::inline metrics
