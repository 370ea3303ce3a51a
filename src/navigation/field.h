// SPDX-License-Identifier: Apache-2.0
// The map of a goal where corners are too many for a graph: an any-angle field over a lattice
// (docs/navigation.md).
#pragma once
#include "navigation/corner_graph.h"
#include "navigation/path_map.h"

namespace avo::inline navigation {

/// Fills length and next of a map with a free goal, for a graph with a lattice.
void spread_field(const CornerGraph& graph, PathMap& map);

}  // namespace avo::inline navigation
