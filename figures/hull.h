// SPDX-License-Identifier: Apache-2.0
// Convex hulls of drawn points.
#pragma once
#include <vector>

#include "avo/vec.h"

namespace avo::figures {

/// Returns the corners of the convex hull, counter-clockwise, by Andrew's monotone chain. Fewer
/// than three places are returned as they are.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

}  // namespace avo::figures
