// SPDX-License-Identifier: Apache-2.0
// Boxes of a scene as finite bodies, for viewers.
#pragma once
#include <vector>

#include "avo/space/scenario.h"
#include "avo/vec.h"

namespace avo_io {

/// A box as a cube from (-1, -1, -1) to (1, 1, 1) that is scaled, turned about the vertical and
/// moved.
struct SolidBox {
  avo::Vec3 center;  ///< m
  avo::Vec3 half;    ///< m, > 0: half of its size
  avo::Vec2 turn;    ///< cosine and sine of half of its heading: z of the quaternion is the sine
};

/// Returns the boxes of the scene. A box with infinite bounds ends around all starts and goals; a
/// floor, a ceiling or a wall is a slab. The radius of a box makes it larger, with sharp edges.
std::vector<SolidBox> solid_boxes_of(const avo::space::Scenario& scene);

}  // namespace avo_io
