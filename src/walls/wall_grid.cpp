// SPDX-License-Identifier: Apache-2.0
// Compressed rows of walls, cell by cell.
#include "walls/wall_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace avo::inline walls {
namespace {

constexpr double kMostCells = 0x1p18;
constexpr std::size_t kMostEntries = std::size_t{1} << 22, kMostEntriesEach = 64;
constexpr double kCellsPerReach = 2.0;
// Part of a cell: the error of its border that rounding may cause.
constexpr double kCellRounding = 0x1p-20;

struct Interval {
  double min, max;  // m
};

// x of the part of the wall's segment with y within [low, high], and a little more.
Interval columns_between(const Wall& wall, double low, double high) {
  const double least = std::min(wall.a.x, wall.b.x), most = std::max(wall.a.x, wall.b.x);
  const double rise = wall.b.y - wall.a.y;
  const auto x_at = [&](double y) {
    const double part = (y - wall.a.y) / rise;
    return std::clamp(wall.a.x + part * (wall.b.x - wall.a.x), least, most);
  };
  Interval part{least, most};
  if (!(std::abs(rise) > 0.0)) return part;
  // it enters at its own end or where it crosses the border
  const double bottom = std::min(wall.a.y, wall.b.y), top = std::max(wall.a.y, wall.b.y);
  const double x_low = x_at(std::max(low, bottom)), x_high = x_at(std::min(high, top));
  return {std::min(x_low, x_high), std::max(x_low, x_high)};
}

}  // namespace

struct WallGrid::Run {
  std::size_t row, first, last;  // columns [first, last]
};

template <typename Visit>
void WallGrid::for_each_run(const Wall& wall, double reach, const Visit& visit) const {
  const double within = reach + kCellRounding * side_;
  const auto index = [this](double offset, std::size_t count) {
    const double cell = std::floor(offset / side_);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
  };
  const double bottom = std::min(wall.a.y, wall.b.y) - within;
  const double top = std::max(wall.a.y, wall.b.y) + within;
  const std::size_t last_row = index(top - corner_.y, rows_);
  for (std::size_t row = index(bottom - corner_.y, rows_); row <= last_row; ++row) {
    const double low = corner_.y + static_cast<double>(row) * side_;
    const Interval part = columns_between(wall, low - within, low + side_ + within);
    visit(Run{row, index(part.min - within - corner_.x, columns_),
              index(part.max + within - corner_.x, columns_)});
  }
}

// Counts into first_[cell + 1].
std::size_t WallGrid::count_entries(std::span<const Wall> walls, std::span<const double> reach) {
  first_.assign(columns_ * rows_ + 1, 0);
  std::size_t entries = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    for_each_run(walls[k], reach[k], [&](const Run& run) {
      entries += run.last - run.first + 1;
      for (std::size_t c = run.first; c <= run.last; ++c) ++first_[run.row * columns_ + c + 1];
    });
  }
  return entries;
}

void WallGrid::choose_cells(std::span<const Wall> walls, std::span<const double> reach) {
  const double infinity = std::numeric_limits<double>::infinity();
  Interval x{infinity, -infinity}, y = x;
  double farthest = 0.0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    for (const Vec2 end : {walls[k].a, walls[k].b}) {
      x = {std::min(x.min, end.x - reach[k]), std::max(x.max, end.x + reach[k])};
      y = {std::min(y.min, end.y - reach[k]), std::max(y.max, end.y + reach[k])};
    }
    farthest = std::max(farthest, reach[k]);
  }
  corner_ = {x.min, y.min};
  const double width = x.max - x.min, height = y.max - y.min;
  side_ = std::max({farthest / kCellsPerReach, std::sqrt(width / kMostCells) * std::sqrt(height),
                    std::max(width, height) / kMostCells, std::numeric_limits<double>::min()});
  for (;; side_ *= 2.0) {
    columns_ = static_cast<std::size_t>(width / side_) + 1;
    rows_ = static_cast<std::size_t>(height / side_) + 1;
    const std::size_t entries = count_entries(walls, reach);
    if (entries <= kMostEntries + kMostEntriesEach * walls.size() || columns_ * rows_ == 1) return;
  }
}

void WallGrid::build(std::span<const Wall> walls, std::span<const double> reach) {
  columns_ = rows_ = most_ = 0;
  entries_.clear();
  if (walls.empty()) return;
  choose_cells(walls, reach);
  for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell) {
    most_ = std::max(most_, std::size_t{first_[cell + 1]});
    first_[cell + 1] += first_[cell];
  }
  entries_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < walls.size(); ++k) {
    for_each_run(walls[k], reach[k], [&](const Run& run) {
      for (std::size_t c = run.first; c <= run.last; ++c) {
        entries_[next[run.row * columns_ + c]++] = walls[k];
      }
    });
  }
}

std::span<const Wall> WallGrid::near(Vec2 place) const {
  const double column = std::floor((place.x - corner_.x) / side_);
  const double row = std::floor((place.y - corner_.y) / side_);
  const bool is_within = column >= 0.0 && column < static_cast<double>(columns_) && row >= 0.0 &&
                         row < static_cast<double>(rows_);
  if (!is_within) return {};
  const std::size_t cell =
      static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column);
  return std::span(entries_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
}

}  // namespace avo::inline walls
