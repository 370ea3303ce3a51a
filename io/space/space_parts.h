// SPDX-License-Identifier: Apache-2.0
// The parts of a scene file with `space: 3` that become robots and boxes.
#pragma once
#include <string>
#include <variant>

#include "avo/space/scenario.h"

namespace avo_io {

/// Robots spread evenly over a sphere, from the top to the bottom.
struct SpherePlacement {
  avo::Vec3 center;
  double radius = 10.0;
};
/// Robots uniform in the box from min to max, no two nearer than contact and `clearance`.
struct BoxPlacement {
  avo::Vec3 min, max;
  double clearance = 0.0;
};
/// Robots from `corner` along x, then y, then z.
struct SpaceGridPlacement {
  avo::Vec3 corner;
  double spacing = 2.0;
  int columns = 1, rows = 1;
};
using SpacePlacement = std::variant<SpherePlacement, BoxPlacement, SpaceGridPlacement>;

/// The start, moved by `by`.
struct SpaceOffset {
  avo::Vec3 by;
};

/// Where the robots of a group go.
enum class SpaceGoals : unsigned char {
  antipodal,  ///< the start, reflected in the center of the placement
  permuted,   ///< the starts of the group, permuted in one random cycle
  offset,     ///< the start, moved by a vector
};

/// Many robots of the same kind.
struct SpaceGroup {
  int count = 0;
  avo::space::RobotSetup robot;  ///< all values except position and goal
  SpacePlacement placement;
  SpaceGoals goals = SpaceGoals::antipodal;
  SpaceOffset offset;
  double jitter = 0.0;  ///< m: the largest random offset of starts and goals, in any direction
};

/// A box that a scene lists.
struct SpaceBox {
  avo::Vec3 min, max;
  double heading = 0.0;
};

}  // namespace avo_io
