// SPDX-License-Identifier: Apache-2.0
// Square cells of the plane, unbounded in number, and their places in a table of bounded size.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "avo/vec.h"

namespace avo::inline spatial {

/// A search reads at most so many cell sides around a place...
inline constexpr double kMostSides = 4.0;
/// ...which are at most so many rows and columns. It is twice the expected number where a position
/// is so large that `x - radius` is rounded by as much as the radius.
inline constexpr std::size_t kMostSpan = 20;

inline constexpr double kFarthestCell = 0x1p52;  ///< cells beyond it are merged

/// The cells of one row are consecutive in the table. Each row begins a stride after the one
/// before; all this is modulo the size of the table. Rows that a search reads do not overlap in it,
/// so no point is found twice. Distant cells may share a slot, and their points fail the test of
/// distance. So a distant outlier costs nothing.
struct Cells {
  double per_meter = 1.0;  ///< 1/m, of one side
  std::size_t stride = kMostSpan;
  std::size_t mask = 0;  ///< size of the table, a power of 2, less 1

  [[nodiscard]] std::size_t table() const { return mask + 1; }
  /// Rounding is monotone, here and where a search adds and subtracts its radius: where the exact
  /// numbers are in order, the cells are. So no point is missed because it is rounded into the next
  /// cell. (Rounding towards 0 makes the cells around 0 twice as wide, which does no harm.)
  [[nodiscard]] std::int64_t cell(double coordinate) const {
    if (per_meter == 0.0) return 0;  // sides are infinite
    return static_cast<std::int64_t>(
        std::clamp(coordinate * per_meter, -kFarthestCell, kFarthestCell));
  }
  [[nodiscard]] std::size_t slot(std::int64_t column, std::int64_t row) const {
    return (static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column)) & mask;
  }
  /// The slot of a position, or table() where that is not finite.
  [[nodiscard]] std::uint32_t key(Vec2 position) const {
    return static_cast<std::uint32_t>(is_finite(position) ? slot(cell(position.x), cell(position.y))
                                                          : table());
  }
};

/// The cells that a search must read.
struct CellRange {
  std::int64_t first_column, first_row, last_row;
  std::size_t columns;
};
inline CellRange cells_within(Vec2 p, double radius, const Cells& cells) {
  constexpr double kTiniest = 0x1p-511;  // squares of smaller distances underflow
  // a distance within the radius as computed exceeds it by less than 4 ulp, or underflows
  const double reach = radius * (1.0 + 4.0 * std::numeric_limits<double>::epsilon()) + kTiniest;
  const std::int64_t column = cells.cell(p.x - reach);
  return {column, cells.cell(p.y - reach), cells.cell(p.y + reach),
          static_cast<std::size_t>(cells.cell(p.x + reach) - column) + 1};
}

/// side: m, may be infinite. Rows are consecutive where the positions fill their extent, and
/// scattered otherwise.
Cells make_cells(std::span<const Vec2> positions, double side);

}  // namespace avo::inline spatial
