// SPDX-License-Identifier: Apache-2.0
// The points of a corner graph.
#pragma once
#include <vector>

#include "navigation/clearance_grid.h"

namespace avo {

struct Corner {
  Vec2 point = {};
  double room = 0.0;     // m, to the nearest wall, at most radius + kSpareRoom
  Vec2 outward = {};     // unit, from the wall's end that it lies around
  double most_lean = 1;  // |sine| of the angle between shortest ways and the tangent there
};

/// Points around all ends of walls where convex corners stick out, and in gaps that are hardly
/// wider than a robot of that radius.
std::vector<Corner> corners(const ClearanceGrid& grid, double radius);

/// m, from which the grid has to tell walls for corners().
double corner_reach(double radius, double widest_wall);

}  // namespace avo
