// SPDX-License-Identifier: Apache-2.0
// What a search does besides its lanes, whatever the instruction set.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "core/scalar.h"
#include "neighbors/search.h"

namespace avo {

// Candidates are thinned out when there are so many beyond those kept last...
inline constexpr std::size_t kManyHits = 64;
// ...and so many are ranked by comparing all.
inline constexpr std::size_t kFewHits = 48;

/// Those that may still be found: nearer than the limit, or as near and of a lower index.
struct HitLimit {
  double distance_squared = 0.0;
  int index = std::numeric_limits<int>::max();
};

inline std::size_t more_than(std::size_t count, std::size_t more) {
  return count + std::min(more, std::numeric_limits<std::size_t>::max() - count);
}

inline double squared(double radius) {
  return radius < 0.0 ? -1.0 : radius * radius;
}

/// m², of a candidate.
inline double exact_distance_squared(const NeighborQuery& query, const PlacedPoints& points,
                                     const SearchScratch& scratch, std::size_t candidate) {
  const std::uint32_t place = scratch.place[candidate];
  return norm_squared(Vec2{points.x[place], points.y[place]} - query.position);
}

/// The canonical order of candidates.
inline auto nearer(const NeighborQuery& query, const PlacedPoints& points,
                   const SearchScratch& scratch) {
  return [&](std::uint32_t a, std::uint32_t b) {
    const double to_a = exact_distance_squared(query, points, scratch, a);
    const double to_b = exact_distance_squared(query, points, scratch, b);
    if (to_a != to_b) return to_a < to_b;
    return points.index[scratch.place[a]] < points.index[scratch.place[b]];
  };
}

/// Leaves of the candidates [first, end) the `most` first, and whoever else is near; the limit
/// becomes that of the candidates yet to come. Returns where they end then.
inline std::size_t keep_nearest(const NeighborQuery& query, const PlacedPoints& points,
                                std::size_t first, std::size_t end, HitLimit& limit,
                                SearchScratch& scratch) {
  if (end - first <= query.most) return end;
  const auto at = [&](std::size_t k) {
    return scratch.order.begin() + static_cast<std::ptrdiff_t>(k);
  };
  std::iota(at(first), at(end), static_cast<std::uint32_t>(first));
  const double near_squared = squared(query.near);
  limit = {near_squared, std::numeric_limits<int>::max()};
  if (query.most > 0) {
    const std::size_t last = first + query.most - 1;
    std::nth_element(at(first), at(last), at(end), nearer(query, points, scratch));
    const double distance_squared = exact_distance_squared(query, points, scratch, *at(last));
    if (distance_squared > near_squared) {
      limit = {distance_squared, static_cast<int>(points.index[scratch.place[*at(last)]])};
    }
  }
  const auto kept = std::partition(at(first + query.most), at(end), [&](std::uint32_t k) {
    return exact_distance_squared(query, points, scratch, k) <= near_squared;
  });
  std::sort(at(first), kept);  // each moves to where nobody is that still has to
  for (auto k = at(first); k != kept; ++k, ++first) {
    scratch.distance_squared[first] = scratch.distance_squared[*k];
    scratch.place[first] = scratch.place[*k];
  }
  return first;
}

inline void sort_candidates(const NeighborQuery& query, const Found& hits,
                            const PlacedPoints& points, SearchScratch& scratch) {
  const auto first = scratch.order.begin() + static_cast<std::ptrdiff_t>(hits.first);
  const auto end = first + static_cast<std::ptrdiff_t>(hits.candidates);
  std::iota(first, end, static_cast<std::uint32_t>(hits.first));
  std::sort(first, end, nearer(query, points, scratch));
  for (auto k = first; k != end; ++k) *k = scratch.place[*k];
}

struct SearchKernels {
  std::size_t (*find_candidates)(const PlacedPoints&, std::size_t, SearchScratch&);
};

}  // namespace avo
