// SPDX-License-Identifier: Apache-2.0
// What a robot on its way makes of the map of its goal (docs/navigation.md).
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "navigation/path_map.h"
#include "navigation/path_search.h"

namespace avo::inline navigation {

/// What a robot aims at next, and how.
struct Leg {
  Vec2 aim = {};
  std::uint32_t target = PathMap::kNothing;  // kNothing: no way is known from here
  double length = 0.0;                       // m, of the whole way that is left
  double turn = 0.0;                         // |sin φ| of the turn at the aim, 1 beyond 90 degrees
  double top = std::numeric_limits<double>::infinity();  // m, what v²/a may be here
  [[nodiscard]] bool is_last() const { return target == PathMap::kGoal; }
};

/// Memory to look around with; reuse it and nothing is allocated once it has grown.
struct LegScratch {
  std::vector<std::pair<double, std::uint32_t>> targets;
  PathScratch search;
};

/// From p on: to the target remembered or the one after it while they are in view; with
/// `looks_around`, or where that fails, to whatever in view is on the shortest way. The radius, at
/// most the graph's, is the robot's. Where the map does not tell enough, a search from p takes its
/// place; the leg is the one by the whole map.
Leg next_leg(const CornerGraph& graph, std::shared_ptr<const PathMap>& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch);
/// By a whole map.
Leg next_leg(const CornerGraph& graph, const PathMap& map, Vec2 p, double radius,
             std::uint32_t target, bool looks_around, LegScratch& scratch);

/// The map of the way to the goal from that corner on, or of the goal alone where there is none.
PathMap way_from(const CornerGraph& graph, const PathMap& goal, std::uint32_t corner,
                 PathScratch& scratch);

/// m/s, from which the turns ahead can be made; none for the goal, where the last leg ends.
double speed_limit(const Leg& leg, double max_acceleration);

}  // namespace avo::inline navigation
