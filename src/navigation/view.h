// SPDX-License-Identifier: Apache-2.0
// Which places may be in view of another one: directions around it come in sectors, and a wall that
// covers a sector hides what is behind it there. What is left has yet to be tested exactly.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "avo/wall.h"

namespace avo {

/// How far one sees from a place.
class Horizons {
 public:
  static constexpr std::size_t kSectors = 256;

  /// room: m, that what is seen needs to the walls on the straight way, > 0.
  Horizons(Vec2 place, double room) : place_(place), room_(room) {
    far_.fill(std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] static std::size_t sector_of(Vec2 direction);
  /// The unit directions in which the sectors begin.
  [[nodiscard]] static const std::array<Vec2, kSectors>& borders();

  [[nodiscard]] bool is_hidden(Vec2 q) const {
    return norm_squared(q - place_) > square(far_[sector_of(q - place_)]);
  }
  /// m: nothing farther off matters there.
  void close(std::size_t sector, double distance) {
    if (distance < far_[sector]) far_[sector] = distance;
  }
  [[nodiscard]] double far(std::size_t sector) const { return far_[sector]; }
  [[nodiscard]] double farthest() const;
  /// What that wall hides.
  void block(const Wall& wall);
  /// Whether no place of the square is in view.
  [[nodiscard]] bool hides(Vec2 low, Vec2 high) const;

 private:
  static double square(double x) { return x * x; }
  Vec2 place_;   // m
  double room_;  // m
  std::array<double, kSectors> far_;
};

/// Walls and points by place.
class ViewIndex {
 public:
  ViewIndex() = default;
  ViewIndex(std::span<const Wall> walls, std::span<const Vec2> points);

  /// visit(point) of each one that may be in view; the horizons come nearer meanwhile. m: beyond
  /// the returned distance it has looked at nothing.
  template <typename Visit>
  double look(Vec2 place, Horizons& horizons, const Visit& visit) const;
  /// visit(point) of those in the cell of that place.
  template <typename Visit>
  void for_each_near(Vec2 place, const Visit& visit) const;

 private:
  struct Cell {
    std::int64_t column, row;
  };
  [[nodiscard]] Cell cell_of(Vec2 place) const;
  [[nodiscard]] std::size_t number(Cell cell) const {
    return static_cast<std::size_t>(cell.row * columns_ + cell.column);
  }
  template <typename Visit>
  void for_each_along(const Wall& wall, const Visit& visit) const;
  template <typename Visit>
  void look_into(Cell cell, Vec2 place, Horizons& horizons, const Visit& visit) const;

  std::vector<Wall> walls_;
  std::vector<Vec2> points_;
  Vec2 origin_;        // m
  double side_ = 1.0;  // m, of a cell
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_wall_, wall_, first_point_, point_;  // by cell
};

template <typename Visit>
void ViewIndex::look_into(Cell cell, Vec2 place, Horizons& horizons, const Visit& visit) const {
  if (cell.column < 0 || cell.column >= columns_ || cell.row < 0 || cell.row >= rows_) return;
  const std::size_t k = number(cell);
  if (first_wall_[k] == first_wall_[k + 1] && first_point_[k] == first_point_[k + 1]) return;
  const Vec2 low = origin_ + side_ * Vec2{static_cast<double>(cell.column),
                                          static_cast<double>(cell.row)};
  if (horizons.hides(low, low + side_ * Vec2{1.0, 1.0})) return;
  for (std::uint32_t w = first_wall_[k]; w < first_wall_[k + 1]; ++w)
    horizons.block(walls_[wall_[w]]);
  for (std::uint32_t p = first_point_[k]; p < first_point_[k + 1]; ++p)
    if (!(points_[point_[p]] == place) && !horizons.is_hidden(points_[point_[p]])) visit(point_[p]);
}

template <typename Visit>
double ViewIndex::look(Vec2 place, Horizons& horizons, const Visit& visit) const {
  if (columns_ == 0) return 0.0;
  const Cell middle = cell_of(place);
  const std::int64_t rings = columns_ + rows_;
  for (std::int64_t away = 0; away <= rings; ++away) {
    const double distance = static_cast<double>(away - 1) * side_;
    if (distance > horizons.farthest()) return distance;
    for (std::int64_t row = middle.row - away; row <= middle.row + away; ++row) {
      const bool is_edge = row == middle.row - away || row == middle.row + away;
      const std::int64_t step = is_edge || away == 0 ? 1 : 2 * away;
      for (std::int64_t column = middle.column - away; column <= middle.column + away;
           column += step)
        look_into({column, row}, place, horizons, visit);
    }
  }
  return std::numeric_limits<double>::infinity();
}

template <typename Visit>
void ViewIndex::for_each_near(Vec2 place, const Visit& visit) const {
  if (columns_ == 0) return;
  const std::size_t k = number(cell_of(place));
  for (std::uint32_t p = first_point_[k]; p < first_point_[k + 1]; ++p) visit(point_[p]);
}

}  // namespace avo
