// SPDX-License-Identifier: Apache-2.0
#include "neighbors/nearest.h"

#include <algorithm>

namespace avo {

std::size_t keep_nearest(std::span<NeighborHit> hits, std::size_t most, double near_squared,
                         HitLimit& limit) {
  if (hits.size() <= most) return hits.size();
  if (most == 0) {
    limit = {near_squared, std::numeric_limits<int>::max()};
  } else {
    const auto last = hits.begin() + static_cast<std::ptrdiff_t>(most - 1);
    std::nth_element(hits.begin(), last, hits.end());
    limit = {last->distance_squared, last->index};
    if (near_squared >= limit.distance_squared) {
      limit = {near_squared, std::numeric_limits<int>::max()};
    }
  }
  const auto end =
      std::partition(hits.begin() + static_cast<std::ptrdiff_t>(most), hits.end(),
                     [&](const NeighborHit& hit) { return hit.distance_squared <= near_squared; });
  return static_cast<std::size_t>(end - hits.begin());
}

void sort_hits(std::span<NeighborHit> hits) {
  constexpr std::size_t kFew = 24;
  if (hits.size() > kFew) {
    std::sort(hits.begin(), hits.end());
    return;
  }
  for (std::size_t i = 1; i < hits.size(); ++i) {
    const NeighborHit hit = hits[i];
    std::size_t k = i;
    for (; k > 0 && hit < hits[k - 1]; --k) hits[k] = hits[k - 1];
    hits[k] = hit;
  }
}

}  // namespace avo
