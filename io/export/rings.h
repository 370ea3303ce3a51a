// SPDX-License-Identifier: Apache-2.0
// The rings around what regions leave free.
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

/// Whether the point is inside of the ring.
bool is_inside(const Ring& ring, avo::Vec2 point);

/// All that is inside of all bounds and outside of all solids, smallest part first. Points are
/// rounded to micrometers (farther than 1e8 m from 0 to more), and what is narrower than four of
/// them may be lost. `regions`: closed chains alone, bounds among
/// them. Throws avo::Error where so fine a structure leaves no rings.
std::vector<FreePart> free_parts(std::span<const avo::StaticObstacle> regions);

}  // namespace avo_io
