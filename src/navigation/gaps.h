// SPDX-License-Identifier: Apache-2.0
// Where walls leave so little room that robots pass one behind the other, or in two lanes
// (docs/navigation.md).
#pragma once
#include <span>
#include <vector>

#include "navigation/clearance_grid.h"

namespace avo {

/// The straight line across a way where it is narrowest, between the surfaces of two walls.
struct Gap {
  Vec2 a = {}, b = {};     // m
  double radius = 0.0;     // m, of the largest robots that fit
  bool two_lanes = false;  // room for robots of that radius side by side
  [[nodiscard]] double width() const { return norm(b - a); }
  [[nodiscard]] Vec2 middle() const { return 0.5 * (a + b); }
  /// Unit, to the left of the way from a to b.
  [[nodiscard]] Vec2 ahead() const { return perpendicular(b - a) / norm(b - a); }
};

/// radii: of all robots, ascending, each > 0. The grid has to tell walls from gap_reach().
std::vector<Gap> find_gaps(const ClearanceGrid& grid, std::span<const double> radii);
double gap_reach(std::span<const double> radii, double widest_wall);

/// m: a way with more clearance than this is no longer as narrow as the gap.
double most_clearance(const Gap& gap);

}  // namespace avo
