// SPDX-License-Identifier: Apache-2.0
// The next leg of a robot on its route by the map of its goal (docs/navigation.md).
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "navigation/path_map.h"
#include "navigation/path_search.h"

namespace avo::inline navigation {

/// The next aim of a robot, and its speed limit there.
struct Leg {
  Vec2 aim = {};
  std::uint32_t target = PathMap::kNothing;  // kNothing: no route is known from here
  double length = 0.0;                       // m, of the whole remaining route
  double turn = 0.0;                         // |sin φ| of the turn at the aim, 1 beyond 90 degrees
  double top = std::numeric_limits<double>::infinity();  // m, the largest allowed v²/a here
  [[nodiscard]] bool is_last() const { return target == PathMap::kGoal; }
};

/// Memory for looking around; reuse it and nothing is allocated once it has grown.
struct LegScratch {
  std::vector<std::pair<double, std::uint32_t>> targets;
  PathScratch search;
};

/// The leg from p on: to the remembered target or the one after it while they are in view. With
/// `looks_around`, or where that fails, it leads to the target in view on the shortest route. The
/// radius, at most the graph's, is the robot's. Where the map does not know enough, a search from p
/// replaces it. The leg is always that of the whole map.
Leg next_leg(const CornerGraph& graph, std::shared_ptr<const PathMap>& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch);
/// The leg by a whole map.
Leg next_leg(const CornerGraph& graph, const PathMap& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch);

/// The map of the route to the goal from that corner on, or of the goal alone where there is none.
PathMap route_from(const CornerGraph& graph, const PathMap& goal, std::uint32_t corner,
                   PathScratch& scratch);

/// m/s, from which the robot can make the turns ahead. The goal, where the last leg ends, gives no
/// limit.
double speed_limit(const Leg& leg, double max_acceleration);

}  // namespace avo::inline navigation
