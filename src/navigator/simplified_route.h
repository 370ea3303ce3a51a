// SPDX-License-Identifier: Apache-2.0
// A given route without the points that it does not need. Points that lie close together, as those
// of a grid planner, leave no room for arcs.
#pragma once
#include <span>
#include <vector>

#include "navigator/given_route.h"

namespace avo::inline navigator {

struct SimplifiedRoute {
  std::vector<Waypoint> points;
  double deviation = 0.0;  // m, of the route through them from the route through all points
};

/// Leaves out points as long as the deviation is at most that, m (D. H. Douglas, T. K. Peucker,
/// 1973). The ends, stages and waits stay. points: at least one.
SimplifiedRoute simplified_route(std::span<const Waypoint> points, double most_deviation);

}  // namespace avo::inline navigator
