// SPDX-License-Identifier: Apache-2.0
#include "spatial/cells.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace avo::inline spatial {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kTiniest = 0x1p-511;  // squares of smaller distances underflow

constexpr std::size_t kFewestSlots = 1024;  // so that kMostSpan scattered rows stay apart
// Multiples of the golden ratio spread evenly: any 20 consecutive ones stay 0.034 apart.
constexpr double kGolden = 0.6180339887498949;

// Rows and columns between the outermost finite positions.
struct Extent {
  double columns = 0.0, rows = 0.0;
};

Extent extent_of(std::span<const Vec2> positions, const Cells& cells) {
  Vec2 low{kLargest, kLargest}, high{-kLargest, -kLargest};
  for (const Vec2 p : positions) {
    if (!is_finite(p)) continue;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto cells_between = [&](double from, double to) {
    return static_cast<double>(cells.cell(to)) - static_cast<double>(cells.cell(from)) + 1.0;
  };
  if (!(low.x <= high.x)) return {};
  return {cells_between(low.x, high.x), cells_between(low.y, high.y)};
}

}  // namespace

Cells make_cells(std::span<const Vec2> positions, double side) {
  Cells cells;
  cells.per_meter = 1.0 / std::max(side, kTiniest);
  const std::size_t scattered = std::bit_ceil(std::max(2 * positions.size(), kFewestSlots));
  // robots leave their present extent: add a few columns
  const Extent extent = extent_of(positions, cells);
  const double stride = extent.columns + static_cast<double>(kMostSpan);
  const double slots = stride * std::max(extent.rows, static_cast<double>(kMostSpan));
  if (slots <= static_cast<double>(scattered)) {
    cells.stride = static_cast<std::size_t>(stride);
    cells.mask = std::bit_ceil(static_cast<std::size_t>(slots)) - 1;
  } else {
    cells.stride = static_cast<std::size_t>(kGolden * static_cast<double>(scattered));
    cells.mask = scattered - 1;
  }
  return cells;
}

}  // namespace avo::inline spatial
