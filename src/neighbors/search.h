// SPDX-License-Identifier: Apache-2.0
// Points within a radius, nearest first: lanes over candidates, the same for every instruction set.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "avo/vec.h"
#include "neighbors/cells.h"

namespace avo {

struct NeighborHit {
  double distance_squared = 0.0;  ///< m², between centers
  int index = 0;                  ///< of the point, or what it was called instead
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

/// Columns of points have room for so many more, which are read but do not count.
inline constexpr std::size_t kMostSearchLanes = 8;

/// Points in the order of their cells.
struct PlacedPoints {
  const Cells& cells;
  std::span<const std::uint32_t> begin;  ///< see CellSort
  const double* x;                       ///< m
  const double* y;
  const double* index;  ///< numbers of 32 bits
};

struct Search {
  Vec2 position;  ///< finite
  int self = -1;  ///< index of a point that is not found
  std::size_t most = std::numeric_limits<std::size_t>::max();
  double near = -1.0;   ///< m, <= radius; all within it are found
  double radius = 0.0;  ///< m, of those within it the `most` first are found
};

/// Allocates only while it grows.
struct SearchScratch {
  std::vector<double> distance_squared, place, rank;  // of candidates
  std::vector<NeighborHit> hits;

  /// Room for so many candidates.
  void reserve(std::size_t count) {
    if (distance_squared.size() < count + kMostSearchLanes) grow(count + kMostSearchLanes);
  }

 private:
  void grow(std::size_t size);
};

/// In canonical order, in the scratch memory.
std::span<const NeighborHit> search_within(const Search& search, const PlacedPoints& points,
                                           SearchScratch& scratch);

}  // namespace avo
