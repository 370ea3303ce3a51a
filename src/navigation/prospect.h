// SPDX-License-Identifier: Apache-2.0
// What lies ahead on a robot's way of passages (docs/arrival.md).
#pragma once
#include <cstdint>
#include <optional>

#include "navigation/corner_graph.h"
#include "navigation/passages.h"
#include "navigation/path_map.h"
#include "navigation/right_of_way.h"

namespace avo::inline navigation {

struct Prospect {
  std::optional<Claim> claim;  // to the passage of one lane that it is in or comes to next
  std::optional<Vec2> lane;    // m: where to go to keep to the right, of two lanes
};

/// From p on by way of the target, which is a corner of the graph or the goal.
Prospect look_ahead(const Passages& passages, const CornerGraph& graph, const PathMap& map, Vec2 p,
                    std::uint32_t target);

/// The next gap on that way, of one lane or two.
std::optional<Passages::Crossing> next_gap(const Passages& passages, const CornerGraph& graph,
                                           const PathMap& map, Vec2 p, std::uint32_t target);

/// Whether all of that way leads through no passage of one lane.
bool has_room_for_two(const Passages& passages, const CornerGraph& graph, const PathMap& map,
                      Vec2 p, std::uint32_t target);

}  // namespace avo::inline navigation
