// SPDX-License-Identifier: Apache-2.0
// What a robot looks for when it senses others.
#pragma once
#include <cstddef>

#include "spatial/search.h"

namespace avo::inline sim {

struct World;

/// The number of nearest neighbors that a search finds. It is all where the robot selects the
/// neighbors that it avoids later.
std::size_t nearest_sought(const World& world);

/// The search query of the robot in that slot.
NeighborQuery sought_by(const World& world, std::size_t slot);

/// m, see Neighbors.
double range_of(const NeighborQuery& query);

}  // namespace avo::inline sim
