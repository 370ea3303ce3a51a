// SPDX-License-Identifier: Apache-2.0
// Finds near points: an exact search on a uniform grid (paper §VI-A).
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "avo/vec.h"
#include "spatial/cell_sort.h"
#include "spatial/cells.h"
#include "spatial/search.h"

namespace avo::inline spatial {

/// Finds exactly the points that comparing all pairs finds: |p_i - position|² <= radius² as
/// computed in double, in canonical order. Positions that are not finite are never found.
class PointGrid {
 public:
  /// Copies the positions. radius: m, of gather(), >= 0, may be infinite. Allocates only while the
  /// number of points grows.
  void build(std::span<const Vec2> positions, double radius);

  /// The first `most` of the points within the radius other than `self`, see find().
  std::span<const NeighborHit> gather(Vec2 position, int self, std::size_t most,
                                      SearchScratch& scratch) const;

  /// Builds in parts, for points with cells known by their keys: prepare(), then each part, which
  /// may be at the same time. `indices` are the numbers given to the points.
  void prepare(const Cells& cells, std::size_t count);
  SortedPart build_part(std::span<const std::uint32_t> keys, std::span<const Vec2> positions,
                        std::span<const int> indices, std::size_t part, std::size_t parts);

  /// Builds with these points alone, as few as a search would read anyway: positions[k] is that of
  /// points[k], with the number indices[k].
  void take(std::span<const std::uint32_t> points, std::span<const Vec2> positions,
            std::span<const int> indices);
  /// Places of all points within the radius of a finite place, in no order.
  void list_within(Vec2 center, double radius, std::vector<std::uint32_t>& places) const;

  /// Answers one query after the other until all are done or there are `enough` candidates. Returns
  /// the number done; the found points are in the scratch memory. Safe to call from several
  /// threads.
  std::size_t find(std::span<const NeighborQuery> queries, std::size_t enough,
                   SearchScratch& scratch) const;
  /// The points that a query found, in canonical order, in the scratch memory.
  std::span<const NeighborHit> list(std::size_t query, SearchScratch& scratch) const;

  /// The index of the given point at each place.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return sort_.order; }
  /// Call it once the owner of the points has put them in that order.
  void forget_order();
  [[nodiscard]] Vec2 position(std::size_t place) const { return {x_[place], y_[place]}; }
  /// The number given to the point there.
  [[nodiscard]] int index(std::size_t place) const { return static_cast<int>(index_[place]); }

 private:
  Cells cells_;
  CellSort sort_;
  std::vector<double> x_, y_;  // m, by place, and kSparePoints more
  std::vector<double> index_;  // by place, and kSparePoints more; numbers of 32 bits

  // for build() and gather()
  double radius_ = 0.0;  // m
  std::vector<std::uint32_t> keys_;
  std::vector<int> indices_;
};

}  // namespace avo::inline spatial
