// SPDX-License-Identifier: Apache-2.0
// Compressed rows of the numbers of segments, cell by cell.
#include "spatial/segment_grid.h"

#include <cmath>
#include <limits>

namespace avo::inline spatial {
namespace {

constexpr std::size_t kMostEntries = std::size_t{1} << 22, kMostEntriesEach = 64;

}  // namespace

SegmentGrid::SegmentGrid(std::span<const Wall> walls, std::span<const double> reach,
                         const CellSize& size)
    : walls_(walls.begin(), walls.end()) {
  if (walls_.empty()) return;
  choose_cells(reach, size);
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  numbers_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t k = 0; k < walls_.size(); ++k) {
    for_each_cell(walls_[k], reach[k], [&](std::size_t cell) { numbers_[next[cell]++] = k; });
  }
}

// Calls visit(cell). A point without reach is in one list alone.
template <typename Visit>
void SegmentGrid::for_each_cell(const Wall& segment, double reach, const Visit& visit) const {
  if (reach == 0.0 && segment.a == segment.b) return visit(number(cell_of(segment.a)));
  all_runs(segment, reach, [&](std::int64_t row, const Stretch& columns) {
    for (std::int64_t c = columns.first; c <= columns.last; ++c) visit(number({c, row}));
    return true;
  });
}

void SegmentGrid::choose_cells(std::span<const double> reach, const CellSize& size) {
  const double infinity = std::numeric_limits<double>::infinity();
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    for (const Vec2 end : {walls_[k].a, walls_[k].b}) {
      low = {std::min(low.x, end.x - reach[k]), std::min(low.y, end.y - reach[k])};
      high = {std::max(high.x, end.x + reach[k]), std::max(high.y, end.y + reach[k])};
    }
  }
  corner_ = low;
  const Vec2 extent = high - low;
  side_ = std::max({size.least, std::sqrt(extent.x / size.most_cells) * std::sqrt(extent.y),
                    std::max(extent.x, extent.y) / size.most_cells,
                    std::numeric_limits<double>::min()});
  for (;; side_ *= 2.0) {
    columns_ = static_cast<std::int64_t>(extent.x / side_) + 1;
    rows_ = static_cast<std::int64_t>(extent.y / side_) + 1;
    const std::size_t most = kMostEntries + kMostEntriesEach * walls_.size();
    if (count_entries(reach) <= most || columns_ * rows_ == 1) return;
  }
}

// Counts into first_[cell + 1].
std::size_t SegmentGrid::count_entries(std::span<const double> reach) {
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  std::size_t entries = 0;
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    for_each_cell(walls_[k], reach[k], [&](std::size_t cell) { ++entries, ++first_[cell + 1]; });
  }
  return entries;
}

std::size_t SegmentGrid::count_near(Vec2 p) const {
  std::size_t count = 0;
  all_runs({p, p}, 0.0, [&](std::int64_t row, const Stretch& columns) {
    for (std::int64_t c = columns.first; c <= columns.last; ++c) count += list({c, row}).size();
    return true;
  });
  return count;
}

std::size_t SegmentGrid::most_listed() const {
  std::uint32_t most = 0;
  for (std::size_t k = 1; k < first_.size(); ++k) most = std::max(most, first_[k] - first_[k - 1]);
  return most;
}

std::span<const std::uint32_t> SegmentGrid::list_at(Vec2 place) const {
  const double column = (place.x - corner_.x) / side_, row = (place.y - corner_.y) / side_;
  const bool is_within = column >= 0.0 && column < static_cast<double>(columns_) && row >= 0.0 &&
                         row < static_cast<double>(rows_);
  if (!is_within) return lists().first(0);
  return list({static_cast<std::int64_t>(column), static_cast<std::int64_t>(row)});
}

SegmentGrid::Cell SegmentGrid::cell_of(Vec2 place) const {
  const auto along = [this](double length, std::int64_t count) {
    return static_cast<std::int64_t>(
        std::clamp(length / side_, 0.0, static_cast<double>(count - 1)));
  };
  return {along(place.x - corner_.x, columns_), along(place.y - corner_.y, rows_)};
}

bool SegmentGrid::covers(Vec2 place) const {
  const Vec2 in = place - corner_;
  return in.x >= 0.0 && in.y >= 0.0 && in.x <= side_ * static_cast<double>(columns_) &&
         in.y <= side_ * static_cast<double>(rows_);
}

}  // namespace avo::inline spatial
