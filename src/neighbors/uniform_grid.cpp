// SPDX-License-Identifier: Apache-2.0
// The grid search: counting sort into a table of cells, exact distances (paper §VI-A).
#include "neighbors/uniform_grid.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace avo {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A search reads three rows and columns, six where a position is so large that `x - radius` is
// rounded by as much as the radius.
constexpr std::size_t kFewestSlots = 128;

constexpr double kTiniest = 0x1p-511;     // squares of smaller distances underflow
constexpr double kFarthestCell = 0x1p52;  // cells beyond it are one

// The nearest `most`: a heap with the farthest of them in front, as long as there are more.
void keep_nearest(std::vector<NeighborHit>& hits, std::size_t most, const NeighborHit& hit) {
  if (hits.size() < most) {
    hits.push_back(hit);
    if (hits.size() == most) std::make_heap(hits.begin(), hits.end());
  } else if (most > 0 && hit < hits.front()) {
    std::pop_heap(hits.begin(), hits.end());
    hits.back() = hit;
    std::push_heap(hits.begin(), hits.end());
  }
}

// A cell side for radius 0, where any side is right: about one cell per point of a line.
double side_without_radius(std::span<const Vec2> positions) {
  double farthest = 0.0;
  for (Vec2 p : positions) {
    if (is_finite(p)) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  }
  return farthest > 0.0 ? farthest / static_cast<double>(positions.size()) : 1.0;
}

}  // namespace

// Rounding is monotone, here and in `x - radius` below: where the exact numbers are in order, the
// cells are. So no point is missed for being rounded into the next cell. (Rounding towards 0 makes
// the cells around 0 twice as wide, which is as good.)
std::int64_t UniformGrid::cell(double coordinate) const {
  return static_cast<std::int64_t>(
      std::clamp(std::clamp(coordinate, -kLargest, kLargest) * cells_per_meter_, -kFarthestCell,
                 kFarthestCell));
}

// Multiples of the golden ratio spread the rows evenly over the table. Any six that follow each
// other stay 0.09 of the table apart: room for the columns of a search, so that none is read twice.
std::size_t UniformGrid::row_start(std::int64_t row) const {
  return static_cast<std::size_t>((static_cast<std::uint64_t>(row) * 0x9e3779b97f4a7c15u) >>
                                  hash_shift_);
}

void UniformGrid::build(std::span<const Vec2> positions, double radius) {
  radius_ = radius * radius < kInfinity ? radius : kInfinity;
  cells_per_meter_ =
      1.0 / std::max(radius > 0.0 ? radius_ : side_without_radius(positions), kTiniest);
  const std::size_t table = std::bit_ceil(2 * positions.size() + kFewestSlots);
  hash_shift_ = 64 - std::countr_zero(table);
  const auto slot = [&](Vec2 p) {
    return (row_start(cell(p.y)) + static_cast<std::size_t>(cell(p.x))) & (table - 1);
  };

  // counting sort: begin_[s + 1] counts slot s, becomes where it begins, and then where it ends
  begin_.assign(table + 1, 0);
  int found = 0;
  for (Vec2 p : positions) {
    if (is_finite(p)) ++begin_[slot(p) + 1], ++found;
  }
  int before = 0;
  for (std::size_t s = 1; s <= table; ++s) before += std::exchange(begin_[s], before);
  entries_.resize(static_cast<std::size_t>(found));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!is_finite(positions[i])) continue;
    const auto place = static_cast<std::size_t>(begin_[slot(positions[i]) + 1]++);
    entries_[place] = {positions[i], static_cast<int>(i)};
  }
}

void UniformGrid::gather(Vec2 position, int self, std::size_t most,
                         std::vector<NeighborHit>& out) const {
  out.clear();
  if (!is_finite(position)) return;
  // a distance within the radius as computed exceeds it by less than 4 ulp, or underflows
  const double reach = radius_ * (1.0 + 4.0 * std::numeric_limits<double>::epsilon()) + kTiniest;
  const double radius_squared = radius_ * radius_;
  const std::size_t mask = begin_.size() - 2;
  const std::int64_t first_column = cell(position.x - reach);
  const auto columns = static_cast<std::size_t>(cell(position.x + reach) - first_column) + 1;

  const std::int64_t last_row = cell(position.y + reach);
  for (std::int64_t row = cell(position.y - reach); row <= last_row; ++row) {
    const std::size_t first = row_start(row) + static_cast<std::size_t>(first_column);
    for (std::size_t k = 0; k < columns; ++k) {
      const std::size_t slot = (first + k) & mask;
      for (int e = begin_[slot]; e < begin_[slot + 1]; ++e) {
        const Entry& entry = entries_[static_cast<std::size_t>(e)];
        const double distance_squared = norm_squared(entry.position - position);
        if (distance_squared > radius_squared || entry.index == self) continue;
        keep_nearest(out, most, {distance_squared, entry.index});
      }
    }
  }
  std::sort(out.begin(), out.end());
}

}  // namespace avo
