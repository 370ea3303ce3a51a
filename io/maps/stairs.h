// SPDX-License-Identifier: Apache-2.0
// Slanting walls in maps of cells are stairs; what becomes of these.
#pragma once
#include <vector>

#include "avo/wall.h"
#include "io/maps/occupancy_grid.h"

namespace avo_io {

/// The contour with the steps of stairs, one cell wide and one high, cut off: from one of their
/// corners that stick out into free space to the next; and so the last cell of a longer step beside
/// them. Free space only shrinks: a step loses its half of a free cell, so that the new wall is
/// half a cell from the old ones at most.
Contour without_stairs(const Contour& contour);

/// Gives obstacles their measured walls back, but where cells are smaller than a quarter of
/// `radius`, m, of the smallest robot: such a robot does not get into the corner of a step.
void restore_large_stairs(std::vector<avo::StaticObstacle>& obstacles, double radius);

}  // namespace avo_io
