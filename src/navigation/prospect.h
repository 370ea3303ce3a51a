// SPDX-License-Identifier: Apache-2.0
// The passages ahead on a robot's route (docs/arrival.md).
#pragma once
#include <cstdint>
#include <optional>

#include "navigation/corner_graph.h"
#include "navigation/passages.h"
#include "navigation/path_map.h"
#include "navigation/right_of_way.h"

namespace avo::inline navigation {

struct Prospect {
  std::optional<Claim> claim;  // for the passage of one lane that the robot is in or comes to next
  // m: the place to move to in order to keep to the right, for two lanes
  std::optional<Vec2> lane;
};

/// Looks ahead from p on through the target, which is a corner of the graph or the goal. reach: m,
/// from p to the farthest center of a footprint.
Prospect look_ahead(const Passages& passages, const CornerGraph& graph, const PathMap& map, Vec2 p,
                    std::uint32_t target, double reach = 0.0);

/// The next gap on that route, of one lane or two.
std::optional<Passages::Crossing> next_gap(const Passages& passages, const CornerGraph& graph,
                                           const PathMap& map, Vec2 p, std::uint32_t target);

/// Returns whether the whole route leads through no passage of one lane.
bool has_room_for_two(const Passages& passages, const CornerGraph& graph, const PathMap& map,
                      Vec2 p, std::uint32_t target);

}  // namespace avo::inline navigation
