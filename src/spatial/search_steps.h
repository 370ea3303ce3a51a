// SPDX-License-Identifier: Apache-2.0
// The parts of a search without lanes, for every instruction set.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>

#include "core/scalar.h"
#include "spatial/search.h"

namespace avo::inline spatial {

// Candidates that are not near are thinned out when so many more than twice `most` are left.
inline constexpr std::size_t kManyHits = 64;

/// The limit of points that may still be found: nearer than the limit, or equally near with a lower
/// index.
struct HitLimit {
  double distance_squared = 0.0;
  int index = std::numeric_limits<int>::max();
};

/// The number of candidates that are not near at which these are thinned out: at least as many as
/// are kept are then removed.
inline std::size_t many_beside(std::size_t most) {
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  return most < (kAll - kManyHits) / 2 ? 2 * most + kManyHits : kAll;
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

/// Keeps the first `most` of the candidates [first, end), and all others that are near. The limit
/// becomes that of later candidates. Returns their new end.
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
  std::sort(at(first), kept);  // each moves to a place that no other still has to leave
  for (auto k = at(first); k != kept; ++k, ++first) {
    scratch.distance_squared[first] = scratch.distance_squared[*k];
    scratch.place[first] = scratch.place[*k];
  }
  return first;
}

/// Puts the keys of many candidates into buckets of equal intervals of their squared distances;
/// even crowds put about one into each. The memory of the order is scratch memory until then.
inline void spread_keys(const NeighborQuery& query, const Found& hits, const PlacedPoints& points,
                        SearchScratch& scratch) {
  const float* const distance = scratch.distance_squared.data() + hits.first;
  std::uint32_t* const next = scratch.order.data() + hits.first;
  const std::size_t last = hits.candidates - 1;
  const float farthest = *std::max_element(distance, distance + hits.candidates);
  const double per_bucket = static_cast<double>(last) / static_cast<double>(farthest);
  const double scale = std::isfinite(per_bucket) ? per_bucket : 0.0;
  const auto bucket = [&](float d) {
    return d < farthest ? static_cast<std::size_t>(static_cast<double>(d) * scale) : last;
  };
  std::fill_n(next, hits.candidates, 0U);
  for (std::size_t k = 0; k < hits.candidates; ++k) ++next[bucket(distance[k])];
  std::exclusive_scan(next, next + hits.candidates, next, 0U);
  for (std::size_t k = 0; k < hits.candidates; ++k) {
    const std::uint32_t place = scratch.place[hits.first + k];
    const Vec2 p = Vec2{points.x[place], points.y[place]} - query.position;
    scratch.keys[next[bucket(distance[k])]++] = {norm_squared(p),
                                                 static_cast<int>(points.index[place]), place};
  }
}

/// Sorts a nearly sorted list in a few moves each, and any other list.
inline void settle(std::span<NeighborHit> keys) {
  std::size_t moves = 8 * keys.size();
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const NeighborHit key = keys[i];
    std::size_t k = i;
    for (; k > 0 && key < keys[k - 1]; --k) keys[k] = keys[k - 1];
    keys[k] = key;
    if (i - k > moves) return std::sort(keys.begin(), keys.end());
    moves -= i - k;
  }
}

inline void sort_candidates(const NeighborQuery& query, const Found& hits,
                            const PlacedPoints& points, SearchScratch& scratch) {
  spread_keys(query, hits, points, scratch);
  settle({scratch.keys.data(), hits.candidates});
  std::uint32_t* const order = scratch.order.data() + hits.first;
  for (std::size_t k = 0; k < hits.candidates; ++k) order[k] = scratch.keys[k].place;
}

struct SearchKernels {
  std::size_t (*find_candidates)(const PlacedPoints&, std::size_t, SearchScratch&);
};

}  // namespace avo::inline spatial
