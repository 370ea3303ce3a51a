// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "space/routes/search.h"

namespace avo::space {

/// Leaves out each point of the route if the points beside it see each other. Moves the others to
/// where the route is shortest, and no nearer to boxes. from: where the route begins.
void tighten(const Solids& solids, const SpaceRoutePoint& from, double most_room,
             std::vector<SpaceRoutePoint>& points);

/// Returns whether a straight line leads from one point to the other, with the room of both.
bool is_free_between(const Solids& solids, const SpaceRoutePoint& a, const SpaceRoutePoint& b);

/// m: from a place through all points.
double route_length(Vec3 from, std::span<const SpaceRoutePoint> points);

}  // namespace avo::space
