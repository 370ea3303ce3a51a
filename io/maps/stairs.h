// SPDX-License-Identifier: Apache-2.0
// Slanting walls in maps of cells look like stairs; this file smooths them.
#pragma once
#include <vector>

#include "avo/wall.h"
#include "io/maps/occupancy_grid.h"

namespace avo_io {

/// Returns the contour with the steps of stairs, one cell wide and one high, cut off. The cut runs
/// from one corner that sticks out into free space to the next. It also takes the last cell of a
/// longer step beside them. Free space only shrinks. A step loses its half of a free cell, so the
/// new wall is at most half a cell from the old walls.
Contour without_stairs(const Contour& contour);

/// Gives obstacles their measured walls back, unless cells are smaller than a quarter of `radius`,
/// m, of the smallest robot. Such a robot does not fit into the corner of a step.
void restore_large_stairs(std::vector<avo::StaticObstacle>& obstacles, double radius);

}  // namespace avo_io
