// SPDX-License-Identifier: Apache-2.0
// Cells over walls, for maps with too many corners to test all pairs of them (docs/navigation.md).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "navigation/clearance_grid.h"
#include "spatial/cell_sort.h"

namespace avo::inline navigation {

/// m, that routes keep from walls beyond the robot's radius, where there is room for it.
inline constexpr double kSpareRoom = 0.05;
inline constexpr std::array kSpareParts{1.0, 0.25, 0.02, 1e-4, 1e-7};  // tried in this order

/// Square cells that cover all walls and one free cell around them. Their places depend on the
/// spacing alone, so that no distant wall changes the content of a cell.
struct Lattice {
  double spacing = 0.0;                          // m
  std::int64_t first_column = 0, first_row = 0;  // spacings from the origin
  std::int64_t columns = 0, rows = 0;
  CellSort corners;  // by cell

  [[nodiscard]] bool empty() const { return columns == 0; }
  [[nodiscard]] bool covers(Vec2 p) const;
  [[nodiscard]] Vec2 middle_of(std::size_t cell) const;
  [[nodiscard]] std::size_t cells() const { return static_cast<std::size_t>(columns * rows); }

  struct LatticeCell {
    std::int64_t column, row;
  };
  /// The nearest cell to p.
  [[nodiscard]] LatticeCell place_of(Vec2 p) const;
  [[nodiscard]] std::size_t cell_of(Vec2 p) const {
    const LatticeCell place = place_of(p);
    return static_cast<std::size_t>(place.row * columns + place.column);
  }
  /// Calls visit(cell) for the cells that are exactly so many columns or rows away.
  template <typename Visit>
  void for_each_around(LatticeCell place, std::int64_t away, const Visit& visit) const;
  /// Calls visit(cell) for the outermost cells.
  template <typename Visit>
  void for_each_on_border(const Visit& visit) const;
  [[nodiscard]] std::span<const std::uint32_t> corners_in(std::size_t cell) const {
    const std::uint32_t first = corners.begin[cell], last = corners.begin[cell + 1];
    return std::span(corners.order).subspan(first, last - first);
  }
};

/// Makes the lattice over the walls of the grid, with the corners sorted into it. The radius is the
/// robots'.
Lattice make_lattice(const ClearanceGrid& grid, std::span<const Vec2> corners, double radius);

/// Its approximate number of cells.
double lattice_cells(const ClearanceGrid& grid, double radius);

/// A place where a robot may be, and its clearance from walls, at most radius + kSpareRoom.
struct Sample {
  Vec2 point = {};
  double room = 0.0;  // m
};

/// A sample in that cell. It is none where one is hard to find, which nearly always means that
/// there is none.
std::optional<Sample> sample_in(const Lattice& lattice, std::size_t cell, const ClearanceGrid& grid,
                                double radius);

template <typename Visit>
void Lattice::for_each_around(LatticeCell place, std::int64_t away, const Visit& visit) const {
  for (std::int64_t row = place.row - away; row <= place.row + away; ++row) {
    if (row < 0 || row >= rows) continue;
    const bool is_edge = row == place.row - away || row == place.row + away;
    const std::int64_t step = is_edge || away == 0 ? 1 : 2 * away;
    for (std::int64_t column = place.column - away; column <= place.column + away; column += step) {
      if (column >= 0 && column < columns) visit(static_cast<std::size_t>(row * columns + column));
    }
  }
}

template <typename Visit>
void Lattice::for_each_on_border(const Visit& visit) const {
  for (std::int64_t row = 0; row < rows; ++row) {
    const bool is_edge = row == 0 || row == rows - 1;
    for (std::int64_t column = 0; column < columns; column += is_edge ? 1 : columns - 1)
      visit(static_cast<std::size_t>(row * columns + column));
  }
}

}  // namespace avo::inline navigation
