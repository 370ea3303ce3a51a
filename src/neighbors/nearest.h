// SPDX-License-Identifier: Apache-2.0
// Keeping the nearest of many hits.
#pragma once
#include <span>

#include "neighbors/uniform_grid.h"

namespace avo {

/// Those that may still be found: nearer than the limit, or as near and of a lower index.
struct HitLimit {
  double distance_squared = 0.0;
  int index = std::numeric_limits<int>::max();
};

/// Puts the `most` first in front, in any order, and behind them whoever else is within `near`.
/// Returns how many those are; the limit becomes that of the hits yet to come.
std::size_t keep_nearest(std::span<NeighborHit> hits, std::size_t most, double near_squared,
                         HitLimit& limit);

/// Into canonical order.
void sort_hits(std::span<NeighborHit> hits);

}  // namespace avo
