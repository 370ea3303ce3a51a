// SPDX-License-Identifier: Apache-2.0
#include "navigation/clearance_grid.h"

#include <algorithm>
#include <cmath>

#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

constexpr double kMostColumns = 4096.0;  // in either direction
constexpr double kSlack = 1e-6;          // of a cell, more than rounding moves a line in the grid

double distance_squared(Vec2 p, const Segment& segment) {
  return norm_squared(p - nearest_on(segment, p));
}

// Returns whether the segment comes nearer than `limit` to the wall's middle line.
bool comes_nearer(const Segment& way, const Wall& wall, double limit) {
  const auto apart = [limit](double a, double b, double c, double d) {
    return std::min(a, b) - std::max(c, d) >= limit || std::min(c, d) - std::max(a, b) >= limit;
  };
  if (apart(way.a.x, way.b.x, wall.a.x, wall.b.x)) return false;
  if (apart(way.a.y, way.b.y, wall.a.y, wall.b.y)) return false;
  // both ends are beyond the limit on one side of the segment's line
  const Vec2 d = way.b - way.a, e = wall.b - wall.a;
  const double one = cross(d, wall.a - way.a), other = cross(d, wall.b - way.a);
  const double limit_squared = limit * limit;
  const double aside = limit_squared * norm_squared(d) * (1.0 + kLengthRounding);
  if (one * other > 0.0 && one * one > aside && other * other > aside) return false;
  const Segment line{wall.a, wall.b};
  const auto differ = [](double s, double t) { return (s < 0.0) != (t < 0.0); };
  if (differ(one, other) && differ(cross(e, way.a - line.a), cross(e, way.b - line.a))) return true;
  if (distance_squared(wall.a, way) < limit_squared) return true;
  if (distance_squared(wall.b, way) < limit_squared) return true;
  if (distance_squared(way.a, line) < limit_squared) return true;
  return distance_squared(way.b, line) < limit_squared;
}

}  // namespace

double widest_of(std::span<const Wall> walls) {
  double widest = 0.0;
  for (const Wall& wall : walls) widest = std::max(widest, wall.radius);
  return widest;
}

bool is_in_the_way(const Wall& wall, Vec2 p, Vec2 q, double room) {
  return comes_nearer({p, q}, wall, room + wall.radius);
}

ClearanceGrid::ClearanceGrid(std::span<const Wall> walls, double reach)
    : walls_(walls.begin(), walls.end()), reach_(reach) {
  if (walls_.empty()) return;
  Vec2 low = walls_[0].a, high = low;
  for (const Wall& wall : walls_) {
    const double around = reach_ + wall.radius;
    low.x = std::min({low.x, wall.a.x - around, wall.b.x - around});
    low.y = std::min({low.y, wall.a.y - around, wall.b.y - around});
    high.x = std::max({high.x, wall.a.x + around, wall.b.x + around});
    high.y = std::max({high.y, wall.a.y + around, wall.b.y + around});
  }
  const Vec2 size = high - low;
  const double cells = 4.0 * static_cast<double>(walls_.size()) + 64.0;
  cell_ = std::max(
      {reach_, std::sqrt(size.x * size.y / cells), std::max(size.x, size.y) / kMostColumns});
  origin_ = low;
  columns_ = static_cast<std::int64_t>(size.x / cell_) + 1;
  rows_ = static_cast<std::int64_t>(size.y / cell_) + 1;
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  std::vector<std::uint32_t> cells_of_all, count(walls_.size(), 0);
  cells_of_all.reserve(4 * walls_.size());
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    for_each_cell(walls_[k], [&](std::size_t cell) {
      cells_of_all.push_back(static_cast<std::uint32_t>(cell));
      ++count[k], ++first_[cell + 1];
    });
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  numbers_.resize(first_.back());
  std::vector<std::uint32_t> end(first_.begin(), first_.end() - 1);
  const std::uint32_t* cell = cells_of_all.data();
  for (std::uint32_t k = 0; k < walls_.size(); ++k) {
    for (; count[k] > 0; --count[k]) numbers_[end[*cell++]++] = k;
  }
}

template <typename Visit>
void ClearanceGrid::for_each_cell(const Wall& wall, const Visit& visit) const {
  const double around = reach_ + wall.radius;
  const auto cell_of = [this](double length, std::int64_t count) {
    return std::clamp(static_cast<std::int64_t>(std::floor(length / cell_)), std::int64_t{0},
                      count - 1);
  };
  const std::int64_t left = cell_of(std::min(wall.a.x, wall.b.x) - around - origin_.x, columns_);
  const std::int64_t right = cell_of(std::max(wall.a.x, wall.b.x) + around - origin_.x, columns_);
  const std::int64_t top = cell_of(std::max(wall.a.y, wall.b.y) + around - origin_.y, rows_);
  std::int64_t row = cell_of(std::min(wall.a.y, wall.b.y) - around - origin_.y, rows_);
  constexpr double kHalfDiagonal = 0.7072;  // of a cell
  const double farthest = kHalfDiagonal * cell_ + around + kSlack * cell_;
  for (; row <= top; ++row) {
    for (std::int64_t column = left; column <= right; ++column) {
      const Vec2 middle =
          origin_ + cell_ * Vec2{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
      if (distance(middle, {wall.a, wall.b}) <= farthest)
        visit(static_cast<std::size_t>(row * columns_ + column));
    }
  }
}

std::int64_t ClearanceGrid::row_of(double y) const {
  const double row = std::floor((y - origin_.y) / cell_);
  return static_cast<std::int64_t>(std::clamp(row, -1.0, static_cast<double>(rows_)));
}

ClearanceGrid::Columns ClearanceGrid::columns_of(Vec2 p, Vec2 q, std::int64_t row) const {
  const Vec2 lower = p.y < q.y ? p : q, upper = p.y < q.y ? q : p;
  const double height = upper.y - lower.y;
  double from = std::min(p.x, q.x), to = std::max(p.x, q.x);
  if (height > kSlack * cell_) {
    const double bottom = origin_.y + cell_ * (static_cast<double>(row) - kSlack);
    const double top = bottom + (1.0 + 2.0 * kSlack) * cell_;
    const double x_bottom = lower.x + (bottom - lower.y) / height * (upper.x - lower.x);
    const double x_top = lower.x + (top - lower.y) / height * (upper.x - lower.x);
    from = std::max(from, std::min(x_bottom, x_top));
    to = std::min(to, std::max(x_bottom, x_top));
  }
  const auto column_of = [this](double x) {
    return std::clamp(std::floor((x - origin_.x) / cell_), -1.0, static_cast<double>(columns_));
  };
  return {std::max(static_cast<std::int64_t>(column_of(from - kSlack * cell_)), std::int64_t{0}),
          std::min(static_cast<std::int64_t>(column_of(to + kSlack * cell_)), columns_ - 1)};
}

double ClearanceGrid::clearance(Vec2 p) const {
  double least = reach_;
  all_near(p, p, [&](std::size_t k) {
    const Wall& wall = walls_[k];
    least = std::min(least, distance(p, {wall.a, wall.b}) - wall.radius);
    return true;
  });
  return least;
}

std::size_t ClearanceGrid::count_near(Vec2 p) const {
  std::size_t count = 0;
  const std::int64_t row = row_of(p.y);
  if (rows_ == 0 || row < 0 || row >= rows_) return 0;
  const Columns columns = columns_of(p, p, row);
  for (std::int64_t column = columns.first; column <= columns.last; ++column) {
    const auto cell = static_cast<std::size_t>(row * columns_ + column);
    count += first_[cell + 1] - first_[cell];
  }
  return count;
}

bool ClearanceGrid::has_room(Vec2 p, double room) const {
  return all_near(p, p, [&](std::size_t k) {
    return distance(p, {walls_[k].a, walls_[k].b}) - walls_[k].radius >= room;
  });
}

bool ClearanceGrid::is_clear(Vec2 p, Vec2 q, double room) const {
  return all_near(p, q, [&](std::size_t k) { return !is_in_the_way(walls_[k], p, q, room); });
}

const Wall* ClearanceGrid::in_the_way(Vec2 p, Vec2 q, double room) const {
  const Wall* wall = nullptr;
  all_near(p, q, [&](std::size_t k) {
    if (is_in_the_way(walls_[k], p, q, room)) wall = &walls_[k];
    return wall == nullptr;
  });
  return wall;
}

}  // namespace avo::inline navigation
