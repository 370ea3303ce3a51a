// SPDX-License-Identifier: Apache-2.0
// The shortest path of a car that drives forward and cannot turn more sharply than on a circle
// (L. E. Dubins, 1957).
#pragma once
#include <array>

#include "avo/vec.h"

namespace avo::inline navigator {

struct Pose {
  Vec2 place = {};       // m
  double heading = 0.0;  // rad
};

/// A straight piece, or an arc.
struct PathPiece {
  double curvature = 0.0;  // 1/m, > 0: to the left
  double length = 0.0;     // m
};

/// Three pieces, some of which may have no length. radius: m, > 0, of its arcs.
std::array<PathPiece, 3> dubins_path(const Pose& from, const Pose& to, double radius);

}  // namespace avo::inline navigator
