// SPDX-License-Identifier: Apache-2.0
// The set where a function is negative, as closed polygons. Any obstacle can be filled and outlined
// from its membership function alone, whatever the shape of its boundary.
#pragma once
#include <functional>
#include <vector>

#include "avo/vec.h"
#include "figures/canvas.h"

namespace avo::figures {

/// Returns polygons around {u in box: f(u) < 0}, with the interior to the left, cut off at the box.
/// f must be Lipschitz with the given constant: regions that cannot contain the boundary are
/// skipped. The grid has `cells` cells along the longer side of the box. Vertices are interpolated
/// along its edges, and features smaller than a cell may be missed. Requires: cells >= 1, a box
/// that is not empty.
std::vector<std::vector<Vec2>> negative_set(const Box& box, int cells,
                                            const std::function<double(Vec2)>& f, double lipschitz);

}  // namespace avo::figures
