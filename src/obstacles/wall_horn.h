// SPDX-License-Identifier: Apache-2.0
// The half-plane of a wall that the present velocity does not lead into.
#pragma once
#include "obstacles/wall_half_plane.h"

namespace avo::inline obstacles {

/// separating: unit, with separating . v >= 0 and separating . (p - q) >= r for both ends q.
RelativeHalfPlane wall_horn(const WallPair& pair, Vec2 separating, double reach,
                            const Horizon& horizon);

}  // namespace avo::inline obstacles
