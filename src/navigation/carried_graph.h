// SPDX-License-Identifier: Apache-2.0
// The corner graph after an edit, made of the one before (docs/navigation.md).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navigation/corner_graph.h"
#include "navigation/path_map.h"
#include "navigation/wall_changes.h"

namespace avo::inline navigation {

/// What of a graph is in the one among other walls.
struct CarriedGraph {
  std::vector<std::uint32_t> number;  // that each corner has now; kNoCorner: it has been found anew
  std::vector<Zone> changed;          // outside of them all is as it was
};
/// The graph that is made of nothing, sooner. Nothing is carried where much has changed: then
/// `carried` is empty.
CornerGraph corner_graph(std::span<const Wall> walls, double radius, const CornerGraph& before,
                         std::optional<CarriedGraph>& carried,
                         Joining joining = Joining::by_number);

/// Where changes matter to ways of that length, m, and to what the map tells: among many corners,
/// an edge that is long gives way to a shorter one in its sector.
std::vector<Zone> zones_for(const CarriedGraph& carried, const CornerGraph& graph,
                            const PathMap& map, double length);
/// What a map still tells, with the numbers that corners have now: the way from the target on, if
/// what has changed is far from it, and whatever else of corners is as before.
PathMap carried_map(const PathMap& map, std::uint32_t target, const CornerGraph& before,
                    const CarriedGraph& carried, std::span<const Zone> changed);

}  // namespace avo::inline navigation
