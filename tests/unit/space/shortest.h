// SPDX-License-Identifier: Apache-2.0
// A second, slow way to shortest routes among boxes: all pairs of many points around the edges.
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

/// m: the length of the shortest way from a to b that keeps `room` from finite boxes, through
/// points around their edges that are `spacing` m apart; a little longer than the shortest one.
double shortest_length(std::span<const Box> boxes, Vec3 a, Vec3 b, double room, double spacing);

}  // namespace avo::space::tests
