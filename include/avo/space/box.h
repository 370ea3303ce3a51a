// SPDX-License-Identifier: Apache-2.0
// Static obstacles of space. SI units.
#pragma once
#include <limits>

#include "avo/export.h"
#include "avo/vec3.h"

namespace avo::space {

/// All points within `radius` of a box that is turned about the vertical. Bounds may be infinite: a
/// floor, a ceiling, a wall at all heights, a pillar are boxes.
struct Box {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec3 min = {-kFar, -kFar, -kFar};  ///< m, in the frame of the box
  Vec3 max = {kFar, kFar, kFar};     ///< m, >= min
  double heading = 0.0;              ///< rad, counter-clockwise from above, about the origin
  double radius = 0.0;               ///< m, >= 0
};

/// m, from a place to the nearest point of the box; 0 from a place in it.
AVO_API Vec3 displacement_to(const Box& box, Vec3 place);

}  // namespace avo::space
