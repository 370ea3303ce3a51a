// SPDX-License-Identifier: Apache-2.0
// What a search does besides its lanes, whatever the instruction set.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/scalar.h"
#include "neighbors/search.h"

namespace avo {

// Candidates are thinned out when there are so many beyond those kept last...
inline constexpr std::size_t kManyHits = 64;
// ...which is asked after so many places.
inline constexpr std::size_t kBlock = 256;
// So many are ranked by comparing all.
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

/// The cells that a search has to read.
struct CellRange {
  std::int64_t first_column, first_row, last_row;
  std::size_t columns;
};
inline CellRange cells_within(const Search& search, const Cells& cells) {
  constexpr double kTiniest = 0x1p-511;  // squares of smaller distances underflow
  // a distance within the radius as computed exceeds it by less than 4 ulp, or underflows
  const double reach =
      search.radius * (1.0 + 4.0 * std::numeric_limits<double>::epsilon()) + kTiniest;
  const Vec2 p = search.position;
  const std::int64_t column = cells.cell(p.x - reach);
  return {column, cells.cell(p.y - reach), cells.cell(p.y + reach),
          static_cast<std::size_t>(cells.cell(p.x + reach) - column) + 1};
}

inline NeighborHit candidate(const PlacedPoints& points, const SearchScratch& scratch,
                             std::size_t k) {
  const auto place = static_cast<std::int64_t>(scratch.place[k]);
  return {scratch.distance_squared[k], static_cast<int>(points.index[place]),
          static_cast<std::uint32_t>(place)};
}

/// Leaves of the candidates the `most` first, and whoever else is near; the limit becomes that of
/// the candidates yet to come.
inline std::size_t keep_nearest(const Search& search, const PlacedPoints& points, std::size_t count,
                                HitLimit& limit, SearchScratch& scratch) {
  if (count <= search.most) return count;
  const auto hits = scratch.hits.begin(), end = hits + static_cast<std::ptrdiff_t>(count);
  for (std::size_t k = 0; k < count; ++k) scratch.hits[k] = candidate(points, scratch, k);
  const double near_squared = squared(search.near);
  limit = {near_squared, std::numeric_limits<int>::max()};
  auto rest = hits;
  if (search.most > 0) {
    rest = hits + static_cast<std::ptrdiff_t>(search.most);
    const auto last = rest - 1;
    std::nth_element(hits, last, end);
    if (last->distance_squared > near_squared) limit = {last->distance_squared, last->index};
  }
  const auto kept = std::partition(
      rest, end, [&](const NeighborHit& hit) { return hit.distance_squared <= near_squared; });
  const auto left = static_cast<std::size_t>(kept - hits);
  for (std::size_t k = 0; k < left; ++k) {
    scratch.distance_squared[k] = scratch.hits[k].distance_squared;
    scratch.place[k] = scratch.hits[k].place;
  }
  return left;
}

/// Sorts hits that are in order of their distances already.
inline void settle_ties(std::span<NeighborHit> hits) {
  for (std::size_t i = 1; i < hits.size(); ++i) {
    if (hits[i - 1].distance_squared < hits[i].distance_squared) continue;
    const NeighborHit hit = hits[i];
    std::size_t k = i;
    for (; k > 0 && hit < hits[k - 1]; --k) hits[k] = hits[k - 1];
    hits[k] = hit;
  }
}

}  // namespace avo
