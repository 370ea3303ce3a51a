// SPDX-License-Identifier: Apache-2.0
// Points within a radius, nearest first: lanes over candidates, the same for every instruction set.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "avo/vec.h"
#include "spatial/cells.h"

namespace avo::inline spatial {

struct NeighborHit {
  double distance_squared = 0.0;  ///< m², between centers
  int index = 0;                  ///< of the point, or the number given to it instead
  std::uint32_t place = 0;        ///< in the order of the cells

  /// The canonical order of neighbors: by distance, ties by index.
  friend constexpr bool operator<(const NeighborHit& a, const NeighborHit& b) {
    if (a.distance_squared != b.distance_squared) return a.distance_squared < b.distance_squared;
    return a.index < b.index;
  }
  friend constexpr bool operator==(const NeighborHit& a, const NeighborHit& b) {
    return a.distance_squared == b.distance_squared && a.index == b.index;
  }
};

/// Columns of points have room for so many extra entries, which are read but do not count.
inline constexpr std::size_t kSparePoints = 16;

/// Points in the order of their cells.
struct PlacedPoints {
  const Cells& cells;
  std::span<const std::uint32_t> begin;  ///< see CellSort
  const double* x;                       ///< m
  const double* y;
  const double* index;  ///< numbers of 32 bits
};

/// What a search must find: all points within `near`, and the first `most` points within `far`.
struct NeighborQuery {
  Vec2 position;
  int self = -1;  ///< index of a point that is not found, -1: none
  std::size_t most = std::numeric_limits<std::size_t>::max();
  double near = -1.0;  ///< m; negative: this finds no points
  double far = 0.0;    ///< m, at most kMostSides sides of a cell
  double guess = 0.0;  ///< m, first search radius; only the time depends on it
};

/// The candidates of one search, [first, first + candidates) among those of all; the first `count`
/// of SearchScratch::order there are found.
struct Found {
  std::size_t first = 0, candidates = 0, count = 0;
};

/// Memory of searches that are made together. Allocates only while it grows.
struct SearchScratch {
  std::vector<NeighborQuery> queries;
  std::vector<Found> results;  // of each

  std::size_t used = 0;                 // of the following columns, one entry for each candidate
  std::vector<float> distance_squared;  // m², narrowed
  std::vector<std::uint32_t> place;     // in the order of the cells
  std::vector<std::uint32_t> order;     // the same places, finally in canonical order
  std::vector<NeighborHit> keys;        // of one search, while many are sorted
  std::vector<NeighborHit> hits;        // of PointGrid::list()

  /// Reserves room for so many queries with so many candidates in all, and for the search.
  void reserve(std::size_t most_queries, std::size_t candidates) {
    constexpr std::size_t kInTransit = 256;
    queries.reserve(most_queries);
    results.reserve(most_queries);
    hits.reserve(candidates);
    reserve(candidates + most_queries * kSparePoints + kInTransit);
  }
  /// Reserves room for so many candidates.
  void reserve(std::size_t count) {
    if (order.size() < count + 2 * kSparePoints) grow(count + 2 * kSparePoints);
  }

 private:
  void grow(std::size_t size);
};

/// Answers scratch.queries, one after the other, until all are answered or there are `enough`
/// candidates; returns the number answered. Positions must be finite, near and guess at most far.
std::size_t search_within(const PlacedPoints& points, std::size_t enough, SearchScratch& scratch);

}  // namespace avo::inline spatial
