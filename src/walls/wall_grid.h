// SPDX-License-Identifier: Apache-2.0
// The walls near a place: cells of a uniform grid, each of which lists the walls that matter to
// robots within it. One look-up, no search.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"

namespace avo::inline walls {

class WallGrid {
 public:
  /// reach: m, of each wall, from its segment.
  void build(std::span<const Wall> walls, std::span<const double> reach);
  /// All walls within their reach of the place, and more; by their index. Valid until the next
  /// build().
  [[nodiscard]] std::span<const Wall> near(Vec2 place) const;
  /// The largest number of walls that near() returns.
  [[nodiscard]] std::size_t most() const { return most_; }

 private:
  struct Run;  // of cells of one row
  template <typename Visit>
  void for_each_run(const Wall& wall, double reach, const Visit& visit) const;
  [[nodiscard]] std::size_t count_entries(std::span<const Wall> walls,
                                          std::span<const double> reach);
  void choose_cells(std::span<const Wall> walls, std::span<const double> reach);

  Vec2 corner_;        // m, the lower left one
  double side_ = 1.0;  // m, of a cell
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;  // entry of each cell, by rows of cells; one more at the end
  std::vector<Wall> entries_;
  std::size_t most_ = 0;
};

}  // namespace avo::inline walls
