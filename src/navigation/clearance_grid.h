// SPDX-License-Identifier: Apache-2.0
// Walls by place: clearances of points and of line segments, for any walls.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"

namespace avo::inline navigation {

inline constexpr double kLengthRounding = 1e-9;  // of a length, more than its rounding

/// m, the radius of the widest wall.
double widest_of(std::span<const Wall> walls);

/// Returns whether the wall's surface is nearer than `room` to the segment from p to q.
bool is_in_the_way(const Wall& wall, Vec2 p, Vec2 q, double room);

/// A uniform grid in which each cell lists the walls that come within `reach` of it.
class ClearanceGrid {
 public:
  ClearanceGrid() = default;
  ClearanceGrid(std::span<const Wall> walls, double reach);

  [[nodiscard]] std::span<const Wall> walls() const { return walls_; }
  /// m, the range in which walls are found.
  [[nodiscard]] double reach() const { return reach_; }
  /// m, from p to the nearest wall's surface, negative inside it; reach() where none is nearer.
  [[nodiscard]] double clearance(Vec2 p) const;
  /// Returns whether clearance(p) >= room, which is at most reach(); it takes less time.
  [[nodiscard]] bool has_room(Vec2 p, double room) const;
  /// Returns whether no wall's surface is nearer than `room` <= reach() to the segment from p to q.
  [[nodiscard]] bool is_clear(Vec2 p, Vec2 q, double room) const;
  /// A wall whose surface is nearer than `room`; nothing if the segment is clear.
  [[nodiscard]] const Wall* in_the_way(Vec2 p, Vec2 q, double room) const;

  /// Calls holds(index) for the walls within reach() of the segment, and for some others, until it
  /// returns false; a wall may come more than once. Returns whether it was true for all.
  template <typename Holds>
  bool all_near(Vec2 p, Vec2 q, const Holds& holds) const;
  /// The same for the walls within reach() of a box.
  template <typename Holds>
  bool all_in(Vec2 low, Vec2 high, const Holds& holds) const;
  /// m, the side of a cell.
  [[nodiscard]] double cell() const { return cell_; }
  /// The largest number of calls by all_near(p, p).
  [[nodiscard]] std::size_t count_near(Vec2 p) const;

 private:
  struct Columns {
    std::int64_t first, last;
  };
  [[nodiscard]] std::int64_t row_of(double y) const;
  // The cells of a row that the segment meets; slightly more for rounding.
  [[nodiscard]] Columns columns_of(Vec2 p, Vec2 q, std::int64_t row) const;
  template <typename ColumnsIn, typename Holds>
  bool all_in_rows(double low, double high, const ColumnsIn& columns_in, const Holds& holds) const;
  template <typename Visit>
  void for_each_cell(const Wall& wall, const Visit& visit) const;

  std::vector<Wall> walls_;
  double reach_ = 0.0;
  Vec2 origin_ = {};
  double cell_ = 1.0;                    // m
  std::int64_t columns_ = 0, rows_ = 0;  // none without walls
  std::vector<std::uint32_t> first_;     // of each cell, index into numbers_
  std::vector<std::uint32_t> numbers_;   // of walls
};

template <typename Holds>
bool ClearanceGrid::all_near(Vec2 p, Vec2 q, const Holds& holds) const {
  const auto columns_in = [&](std::int64_t row) { return columns_of(p, q, row); };
  return all_in_rows(p.y < q.y ? p.y : q.y, p.y < q.y ? q.y : p.y, columns_in, holds);
}

template <typename Holds>
bool ClearanceGrid::all_in(Vec2 low, Vec2 high, const Holds& holds) const {
  if (rows_ == 0) return true;
  const Columns columns = columns_of({low.x, low.y}, {high.x, low.y}, 0);
  return all_in_rows(
      low.y, high.y, [&](std::int64_t) { return columns; }, holds);
}

template <typename ColumnsIn, typename Holds>
bool ClearanceGrid::all_in_rows(double low, double high, const ColumnsIn& columns_in,
                                const Holds& holds) const {
  if (rows_ == 0) return true;
  const std::int64_t last_row = row_of(high) < rows_ - 1 ? row_of(high) : rows_ - 1;
  for (std::int64_t row = row_of(low) > 0 ? row_of(low) : 0; row <= last_row; ++row) {
    const Columns columns = columns_in(row);
    for (std::int64_t column = columns.first; column <= columns.last; ++column) {
      const auto cell = static_cast<std::size_t>(row * columns_ + column);
      for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k) {
        if (!holds(std::size_t{numbers_[k]})) return false;
      }
    }
  }
  return true;
}

}  // namespace avo::inline navigation
