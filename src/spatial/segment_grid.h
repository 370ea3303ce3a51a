// SPDX-License-Identifier: Apache-2.0
// Which segments are near a place: cells of a uniform grid, each of which lists the segments that
// reach into it.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/wall.h"

namespace avo::inline spatial {

/// The size of a grid's cells, as small as both members allow.
struct CellSize {
  double least = 0.0;       ///< m, of a side
  double most_cells = 1.0;  ///< the approximate number over all segments and their reach
};

/// Cells for reaches and queries of about that length, m. Their number is in proportion to that of
/// the segments.
inline CellSize usual_cells(std::size_t segments, double length) {
  return {length, 4.0 * static_cast<double>(segments) + 64.0};
}

/// Segments by place. Each segment has a reach of its own around it. Queries tell the numbers of
/// all segments that reach a place, and of some others.
class SegmentGrid {
 public:
  struct Cell {
    std::int64_t column = 0, row = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
  };

  SegmentGrid() = default;
  /// Copies the walls, of which only the segments count. reach: m, of each segment.
  SegmentGrid(std::span<const Wall> walls, std::span<const double> reach, const CellSize& size);

  [[nodiscard]] std::span<const Wall> walls() const { return walls_; }

  /// Calls holds(number) for the segments that reach the segment from p to q, until it returns
  /// false; a number may come more than once. Returns whether it was true for all.
  template <typename Holds>
  bool all_near(Vec2 p, Vec2 q, const Holds& holds) const;
  /// The same for the segments that reach a box.
  template <typename Holds>
  bool all_in(Vec2 low, Vec2 high, const Holds& holds) const;
  /// The largest number of calls by all_near(p, p).
  [[nodiscard]] std::size_t count_near(Vec2 p) const;

  /// The numbers of the segments that reach into a cell, ascending.
  [[nodiscard]] std::span<const std::uint32_t> list(Cell cell) const {
    const std::size_t k = number(cell);
    return lists().subspan(first_[k], first_[k + 1] - first_[k]);
  }
  /// The list of the cell that contains the place; empty outside of all cells.
  [[nodiscard]] std::span<const std::uint32_t> list_at(Vec2 place) const;
  /// All lists, cell by cell.
  [[nodiscard]] std::span<const std::uint32_t> lists() const { return numbers_; }
  /// The number of segments in the longest list.
  [[nodiscard]] std::size_t most_listed() const;

  [[nodiscard]] std::int64_t columns() const { return columns_; }
  [[nodiscard]] std::int64_t rows() const { return rows_; }
  /// m, of a cell.
  [[nodiscard]] double side() const { return side_; }
  /// m, the lower left corner of a cell.
  [[nodiscard]] Vec2 corner(Cell cell) const {
    return corner_ + side_ * Vec2{static_cast<double>(cell.column), static_cast<double>(cell.row)};
  }
  /// The cell that contains the place, or is nearest to it.
  [[nodiscard]] Cell cell_of(Vec2 place) const;
  /// Returns whether the place is in a cell.
  [[nodiscard]] bool covers(Vec2 place) const;

 private:
  /// Cells along one axis; none where last < first.
  struct Stretch {
    std::int64_t first, last;
  };
  struct Interval {
    double min, max;  // m
  };
  [[nodiscard]] std::size_t number(Cell cell) const {
    return static_cast<std::size_t>(cell.row * columns_ + cell.column);
  }
  [[nodiscard]] Stretch stretch(double low, double high, std::int64_t count) const;
  [[nodiscard]] static Interval part_between(const Wall& segment, double low, double high);
  template <typename Visit>
  bool all_runs(const Wall& segment, double within, const Visit& visit) const;
  template <typename Holds>
  bool all_of(std::int64_t row, const Stretch& columns, const Holds& holds) const;
  template <typename Visit>
  void for_each_cell(const Wall& segment, double reach, const Visit& visit) const;

  void choose_cells(std::span<const double> reach, const CellSize& size);
  std::size_t count_entries(std::span<const double> reach);

  std::vector<Wall> walls_;
  Vec2 corner_;        // m, the lower left one
  double side_ = 1.0;  // m, of a cell
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;    // of each cell, by rows, and one more: index into numbers_
  std::vector<std::uint32_t> numbers_;  // of segments
};

// The cells that meet low to high, m from the lowest border.
inline SegmentGrid::Stretch SegmentGrid::stretch(double low, double high,
                                                 std::int64_t count) const {
  const double from = low / side_, to = high / side_;
  if (!(to >= 0.0 && from < static_cast<double>(count))) return {0, -1};
  return {static_cast<std::int64_t>(std::max(from, 0.0)),
          static_cast<std::int64_t>(std::min(to, static_cast<double>(count - 1)))};
}

// x of the part of the segment with y in [low, high].
inline SegmentGrid::Interval SegmentGrid::part_between(const Wall& segment, double low,
                                                       double high) {
  const Vec2 a = segment.a, b = segment.b;
  const double least = std::min(a.x, b.x), most = std::max(a.x, b.x), rise = b.y - a.y;
  if (rise == 0.0) return {least, most};
  const auto x_at = [&](double y) {
    return std::clamp(a.x + (y - a.y) / rise * (b.x - a.x), least, most);
  };
  // it enters at its own end or where it crosses the border
  const double x_low = x_at(std::max(low, std::min(a.y, b.y)));
  const double x_high = x_at(std::min(high, std::max(a.y, b.y)));
  return {std::min(x_low, x_high), std::max(x_low, x_high)};
}

// Calls visit(row, columns) for the cells that are so near to the segment, m, and for some others,
// until it returns false.
template <typename Visit>
bool SegmentGrid::all_runs(const Wall& segment, double within, const Visit& visit) const {
  constexpr double kRounding = 0x1p-20;  // of a cell: the error of its border, and more
  within += kRounding * side_;
  const auto [bottom, top] = std::minmax(segment.a.y, segment.b.y);
  const Stretch rows = stretch(bottom - within - corner_.y, top + within - corner_.y, rows_);
  for (std::int64_t row = rows.first; row <= rows.last; ++row) {
    const double low = corner_.y + static_cast<double>(row) * side_;
    const Interval part = part_between(segment, low - within, low + side_ + within);
    const Stretch columns =
        stretch(part.min - within - corner_.x, part.max + within - corner_.x, columns_);
    if (!visit(row, columns)) return false;
  }
  return true;
}

template <typename Holds>
bool SegmentGrid::all_of(std::int64_t row, const Stretch& columns, const Holds& holds) const {
  if (columns.last < columns.first) return true;
  const std::uint32_t last = first_[number({columns.last, row}) + 1];
  for (std::uint32_t k = first_[number({columns.first, row})]; k < last; ++k)
    if (!holds(std::size_t{numbers_[k]})) return false;
  return true;
}

template <typename Holds>
bool SegmentGrid::all_near(Vec2 p, Vec2 q, const Holds& holds) const {
  return all_runs({p, q}, 0.0, [&](std::int64_t row, const Stretch& columns) {
    return all_of(row, columns, holds);
  });
}

template <typename Holds>
bool SegmentGrid::all_in(Vec2 low, Vec2 high, const Holds& holds) const {
  const Stretch columns = stretch(low.x - corner_.x, high.x - corner_.x, columns_);
  const Stretch rows = stretch(low.y - corner_.y, high.y - corner_.y, rows_);
  for (std::int64_t row = rows.first; row <= rows.last; ++row)
    if (!all_of(row, columns, holds)) return false;
  return true;
}

}  // namespace avo::inline spatial
