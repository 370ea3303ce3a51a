// SPDX-License-Identifier: Apache-2.0
// Boxes of space made of what a scene file says.
#pragma once
#include "avo/space/box.h"
#include "avo/wall.h"
#include "io/space/space_parts.h"

namespace avo_io {

/// Returns the box of the bounds, turned about its middle.
avo::space::Box box_of(const SpaceBox& bounds);
/// Returns a wall of the plane, from one height to another, m.
avo::space::Box box_of(const avo::Wall& wall, double low, double high);

}  // namespace avo_io
