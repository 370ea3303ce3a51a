// SPDX-License-Identifier: Apache-2.0
// The points of a corner graph.
#pragma once
#include <cstdint>
#include <vector>

#include "navigation/clearance_grid.h"
#include "navigation/wall_changes.h"

namespace avo::inline navigation {

struct Corner {
  Vec2 point = {};
  double room = 0.0;     // m, to the nearest wall, at most radius + kSpareRoom
  Vec2 outward = {};     // unit, from the wall's end that it lies around
  double most_lean = 1;  // |sine| of the angle between shortest routes and the tangent there
};

/// Points around all ends of walls with convex corners, by the walls. Then the points in gaps that
/// are hardly wider than a robot, by the walls at their ends.
struct Corners {
  std::vector<Corner> all;
  // index of the first one of each wall; one more than walls
  std::vector<std::uint32_t> around, in_gaps;
};
Corners corners(const ClearanceGrid& grid, double radius);
/// The corners where most walls are those of `before`. number: the present number of each corner of
/// `before`; kNoCorner for a corner that was searched for anew.
inline constexpr std::uint32_t kNoCorner = 0xffffffff;
Corners corners(const ClearanceGrid& grid, double radius, const Corners& before,
                const WallChanges& changes, std::vector<std::uint32_t>& number);
/// m, from a wall: no corner farther off depends on it.
double corner_range(const ClearanceGrid& grid);

/// m, range in which the grid must find walls for corners().
double corner_reach(double radius, double widest_wall);

}  // namespace avo::inline navigation
