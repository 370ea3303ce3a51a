// SPDX-License-Identifier: Apache-2.0
// The corner graph after an edit, made from the graph before it (docs/navigation.md).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navigation/corner_graph.h"
#include "navigation/path_map.h"
#include "navigation/wall_changes.h"

namespace avo::inline navigation {

/// The part of a graph that is kept among other walls.
struct CarriedGraph {
  // the present number of each corner; kNoCorner: it has been searched for anew
  std::vector<std::uint32_t> number;
  std::vector<Zone> changed;  // outside of all these zones nothing has changed
};
/// The same graph as one made from nothing, but sooner. Nothing is kept where much has changed:
/// then `carried` is empty.
CornerGraph corner_graph(std::span<const Wall> walls, double radius, const CornerGraph& before,
                         std::optional<CarriedGraph>& carried,
                         Joining joining = Joining::by_number);

/// The zones in which changes matter to routes of that length, m, and to the entries of the map.
/// Among many corners, a shorter edge in its sector replaces a long edge.
std::vector<Zone> zones_for(const CarriedGraph& carried, const CornerGraph& graph,
                            const PathMap& map, double length);
/// The entries of a map that still hold, with the present numbers of corners. They are the route
/// from the target on, if all changes are far from it, and all other entries of corners that have
/// not changed.
PathMap carried_map(const PathMap& map, std::uint32_t target, const CornerGraph& before,
                    const CarriedGraph& carried, std::span<const Zone> changed);

}  // namespace avo::inline navigation
