// SPDX-License-Identifier: Apache-2.0
// Which goals boxes keep robots of space from (docs/space.md, "Routes and passages"). SI units.
#pragma once
#include <vector>

#include "avo/export.h"
#include "avo/ids.h"
#include "avo/space/scenario.h"

namespace avo::space {

/// A robot that cannot reach its goal because of boxes.
struct OutOfReach {
  RobotId robot;               ///< its value is its position in the scene's robots
  Vec3 nearest = {};           ///< m, the place near its goal at which its route ends
  double distance_left = 0.0;  ///< m, from there to the goal
  /// the goal is nearer to a box than the radius; if false, there is no route
  bool is_in_box = false;
};

/// Returns the robots that cannot reach their goals, by robot, for a scene that passes validate().
AVO_API std::vector<OutOfReach> out_of_reach(const Scenario& scenario);

}  // namespace avo::space
