// SPDX-License-Identifier: Apache-2.0
// The rings around the space that regions leave free.
#pragma once
#include <span>
#include <vector>

#include "avo/wall.h"

namespace avo_io {

using Ring = std::vector<avo::Vec2>;  // m, at least 3 points; the last one is not the first

/// One piece of a plane: rings do not cross, and touch in points at most.
struct FreePart {
  Ring outer;               // counter-clockwise
  std::vector<Ring> holes;  // clockwise
};

/// Returns whether the point is inside the ring.
bool is_inside(const Ring& ring, avo::Vec2 point);

/// Returns all space inside all bounds and outside all solids, smallest part first. Points are
/// rounded to micrometers, and to more if they are farther than 1e8 m from 0. Structures narrower
/// than four such units may be lost. `regions`: closed chains alone, which include the bounds.
/// Throws avo::Error if the structure is so fine that no rings are left.
std::vector<FreePart> free_parts(std::span<const avo::StaticObstacle> regions);

}  // namespace avo_io
