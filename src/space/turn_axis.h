// SPDX-License-Identifier: Apache-2.0
// The axis about which a robot turns to its right (docs/space.md, "Arriving").
#pragma once
#include <span>

#include "avo/space/box.h"
#include "avo/space/robot.h"

namespace avo::space {

/// A unit axis across the course, about which a robot turns to its right. It points up as seen
/// along the course, and ahead along x where the course is steep.
Vec3 axis_across(Vec3 heading);

/// The axis of a robot among these boxes. In a slot that leaves no room for two robots side by
/// side, it is the normal of the slot, with the same sign for all robots: so robots that meet pass
/// on different sides in the slot. Elsewhere it is axis_across().
Vec3 turn_axis(const Robot& robot, std::span<const Box> boxes);

}  // namespace avo::space
