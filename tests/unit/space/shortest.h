// SPDX-License-Identifier: Apache-2.0
// A second, slow search finds shortest routes among boxes, with all pairs of many points around the
// edges.
#pragma once
#include <span>
#include <vector>

#include "avo/space/box.h"

namespace avo::space::tests {

inline Box box_of(Vec3 min, Vec3 max) {
  return {min, max, 0.0, 0.0};
}

/// m: from a place to a box, by the definition; negative nowhere.
double distance_of(Vec3 a, const Box& box);

/// m: the length of the shortest route from a to b that keeps `room` from finite boxes. The route
/// leads through points around the box edges that are `spacing` m apart. This length is a little
/// more than the shortest length.
double shortest_length(std::span<const Box> boxes, Vec3 a, Vec3 b, double room, double spacing);

}  // namespace avo::space::tests
