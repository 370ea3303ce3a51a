// SPDX-License-Identifier: Apache-2.0
// The walls near a place, for robots that decide: one look-up, no search.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "spatial/segment_grid.h"

namespace avo::inline walls {

class WallGrid {
 public:
  WallGrid() = default;
  /// reach: m, of each wall, from its segment.
  WallGrid(std::span<const Wall> walls, std::span<const double> reach);
  /// All walls within their reach of the place, and more; by their index. Valid as long as the
  /// grid.
  [[nodiscard]] std::span<const Wall> near(Vec2 place) const {
    const std::span<const std::uint32_t> list = grid_.list_at(place);
    return {entries_.data() + (list.data() - grid_.lists().data()), list.size()};
  }
  /// The indices of those walls, in the list that the grid was made of.
  [[nodiscard]] std::span<const std::uint32_t> numbers_near(Vec2 place) const {
    return grid_.list_at(place);
  }
  /// The largest number of walls that near() returns.
  [[nodiscard]] std::size_t most() const { return most_; }

 private:
  SegmentGrid grid_;
  std::vector<Wall> entries_;  // of all lists: what one look-up returns lies together in memory
  std::size_t most_ = 0;
};

}  // namespace avo::inline walls
