// SPDX-License-Identifier: Apache-2.0
// Where room is scarce, most queries end in a fine cell that is covered, without a test of discs.
#include "io/maps/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace avo_io {

using avo::Disc;
using avo::Vec2;

namespace {

// Distances are compared as doubles: a disc that is left out, or that covers a cell, keeps off
// the limit by this relative margin.
constexpr double kMargin = 1e-8;
constexpr int kFinePerCell = 6;  // along a side

void set_bits(std::vector<std::uint64_t>& bits, std::size_t from, std::size_t to) {
  while (from < to) {
    const std::size_t first = from % 64, count = std::min(64 - first, to - from);
    bits[from / 64] |= ~std::uint64_t{0} >> (64 - count) << first;
    from += count;
  }
}

}  // namespace

FreeSpace::FreeSpace(Vec2 min, Vec2 max, double radius, double clearance, std::size_t count)
    : min_(min),
      size_(max - min),
      radius_(radius),
      clearance_(clearance),
      most_cells_(4.0 * static_cast<double>(count) + 64.0) {
  fine_ = layer_of(radius).cells;
  fine_ = {fine_.side / kFinePerCell, fine_.per_meter * kFinePerCell, kFinePerCell * fine_.columns,
           kFinePerCell * fine_.rows};
  covered_.resize(fine_.count() / 64 + 1);
}

Cells FreeSpace::cells_of(double side) const {
  constexpr double kSmallest = 1e-300;  // m, so that 1/side is finite
  side = std::max({side, std::max(size_.x, size_.y) / most_cells_, kSmallest});
  const auto along = [&](double length) { return std::floor(length / side) + 1.0; };
  while (along(size_.x) * along(size_.y) > most_cells_) side *= 1.25;
  return {side, 1.0 / side, static_cast<int>(along(size_.x)), static_cast<int>(along(size_.y))};
}

FreeSpace::Layer& FreeSpace::layer_of(double radius) {
  double largest = radius_;
  while (largest < radius) largest *= 2.0;
  for (Layer& layer : layers_) {
    if (layer.largest_radius == largest) return layer;
  }
  const Cells cells = cells_of((radius_ + largest + clearance_) * (1.0 + kMargin));
  return layers_.emplace_back(Layer{largest, cells, std::vector<int>(cells.count(), kNone), {}});
}

bool FreeSpace::is_clear(Vec2 center) const {
  const std::size_t cell = fine_index(center);
  if ((covered_[cell / 64] >> (cell % 64) & 1U) != 0) return false;
  return std::all_of(layers_.begin(), layers_.end(),
                     [&](const Layer& layer) { return is_clear_of(layer, center); });
}

bool FreeSpace::is_clear_of(const Layer& layer, Vec2 center) const {
  const Vec2 offset = center - min_;
  const int column = layer.cells.column(offset.x), row = layer.cells.row(offset.y);
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, layer.cells.rows - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, layer.cells.columns - 1); ++x) {
      for (int k = layer.last[layer.cells.index(x, y)]; k != kNone;) {
        const auto& [other, before] = layer.entries[static_cast<std::size_t>(k)];
        if (norm(center - other.center) < radius_ + other.radius + clearance_) return false;
        k = before;
      }
    }
  }
  return true;
}

void FreeSpace::add(const Disc& disc) {
  const double reach = radius_ + disc.radius + clearance_;
  const Vec2 offset = disc.center - min_;
  const double beyond =
      std::max(std::max(-offset.x, offset.x - size_.x), std::max(-offset.y, offset.y - size_.y));
  if (beyond > reach * (1.0 + kMargin)) return;
  Layer& layer = layer_of(disc.radius);
  int& last =
      layer.last[layer.cells.index(layer.cells.column(offset.x), layer.cells.row(offset.y))];
  layer.entries.push_back({disc, last});
  last = static_cast<int>(layer.entries.size()) - 1;
  cover(offset, reach * (1.0 - kMargin) - kMargin * (size_.x + size_.y));
}

// Marks, row by row, the fine cells with all four corners nearer than `reach`.
void FreeSpace::cover(Vec2 offset, double reach) {
  if (!(reach > 0.0)) return;
  const double side = fine_.side;
  const int last = fine_.row(offset.y + reach);
  for (int y = fine_.row(offset.y - reach); y <= last; ++y) {
    const double across =
        std::max(std::abs(y * side - offset.y), std::abs((y + 1) * side - offset.y));
    const double square = reach * reach - across * across;
    if (!(square > 0.0)) continue;
    const double half = std::sqrt(square);
    const double columns = fine_.columns;
    const double from = std::clamp((offset.x - half) / side + 1.0, 0.0, columns);
    const double to = std::clamp((offset.x + half) / side, 0.0, columns);
    set_bits(covered_, fine_.index(static_cast<int>(from), y),
             fine_.index(static_cast<int>(to), y));
  }
}

}  // namespace avo_io
