// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>

#include "navigation/corner_graph.h"
#include "navigation/passages.h"
#include "navigation/path_map.h"

namespace avo::inline navigation {

/// Rule 6 of docs/arrival.md: the place to move to, m, if the route from p on through the target
/// leads along two lanes there. reach: m, from p to the farthest center of a footprint.
std::optional<Vec2> lane_ahead(const Passages& passages, const CornerGraph& graph,
                               const PathMap& map, Vec2 p, std::uint32_t target, double reach);

}  // namespace avo::inline navigation
