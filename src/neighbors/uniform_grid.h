// SPDX-License-Identifier: Apache-2.0
// Who is within the sensing radius: an exact search on a uniform grid (paper §VI-A).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/vec.h"

namespace avo {

struct NeighborHit {
  double distance_squared = 0.0;  ///< m², between centers
  int index = 0;                  ///< into the positions given to build()

  /// The canonical order of neighbors: by distance, ties by index.
  friend constexpr bool operator<(const NeighborHit& a, const NeighborHit& b) {
    if (a.distance_squared != b.distance_squared) return a.distance_squared < b.distance_squared;
    return a.index < b.index;
  }
  friend constexpr bool operator==(const NeighborHit&, const NeighborHit&) = default;
};

/// All points within a fixed radius of any place, exactly those that comparing all pairs finds.
/// The cells, squares of side `radius`, are unbounded in number and kept in a table of O(n) slots:
/// the cells of one row follow each other in it, each row from a scattered start. So a far outlier
/// costs nothing; points of far cells that share a slot fail the test of their distance.
class UniformGrid {
 public:
  /// Copies the positions. radius: m, >= 0, may be infinite. Positions that are not finite are
  /// never found. Allocates only while the number of points grows.
  void build(std::span<const Vec2> positions, double radius);

  /// The points other than `self` (-1: none) within the radius of `position`, closed:
  /// |p_i - position|² <= radius² as computed in double; of those the `most` first in canonical
  /// order. Replaces `out`, sorted; it is empty for a position that is not finite. Allocates only
  /// while `out` grows; safe to call from several threads.
  void gather(Vec2 position, int self, std::size_t most, std::vector<NeighborHit>& out) const;

 private:
  struct Entry {
    Vec2 position;
    int index;
  };

  [[nodiscard]] std::int64_t cell(double coordinate) const;
  [[nodiscard]] std::size_t row_start(std::int64_t row) const;

  double radius_ = 0.0;
  double cells_per_meter_ = 0.0;
  int hash_shift_ = 63;
  std::vector<int> begin_{0, 0, 0};  // entries of slot s: [begin_[s], begin_[s + 1])
  std::vector<Entry> entries_;       // by slot, then by index
};

}  // namespace avo
