// SPDX-License-Identifier: Apache-2.0
// The path of a body of space over one step, and boxes beside it.
#pragma once
#include <cstddef>

#include "avo/space/box.h"
#include "avo/space/check.h"
#include "check/space_path.h"

namespace avo::judge {

struct SpaceStep {
  std::size_t robot;
  Cubic path;
  Vec3 low, high;  ///< m, of the hull of its points
};
SpaceStep step_of(std::size_t robot, const Cubic& path);

/// The path between two states that have velocities.
Cubic path_of(const space::CheckedState& before, const space::CheckedState& now, double duration);
Cubic straight_path(Vec3 from, Vec3 to);
/// The same path in the frame of the box.
Cubic in_frame_of(const space::Box& box, const Cubic& path);

/// m: the gap of two hulls along the axis in which it is widest; negative where they overlap.
double gap(const SpaceStep& a, const SpaceStep& b);

/// Returns whether the straight piece from a place to a goal touches the box, and the goal is not
/// in it.
bool hides(const space::Box& box, Vec3 position, Vec3 goal);

/// The length of a velocity or an acceleration, where limits along the vertical are so much of
/// those along the horizontal.
double weighed(Vec3 a, double vertical);
/// Returns whether the second velocity is the first one, slowed down straight.
bool slows_straight(Vec3 from, Vec3 to);

}  // namespace avo::judge
