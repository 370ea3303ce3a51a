// SPDX-License-Identifier: Apache-2.0
#include "walls/wall_grid.h"

#include <algorithm>

namespace avo::inline walls {
namespace {

constexpr double kMostCells = 0x1p18;
constexpr double kCellsPerReach = 2.0;

}  // namespace

WallGrid::WallGrid(std::span<const Wall> walls, std::span<const double> reach) {
  if (walls.empty()) return;
  const double farthest = *std::max_element(reach.begin(), reach.end());
  grid_ = SegmentGrid(walls, reach, {farthest / kCellsPerReach, kMostCells});
  entries_.reserve(grid_.lists().size());
  for (const std::uint32_t k : grid_.lists()) entries_.push_back(walls[k]);
  most_ = grid_.most_listed();
}

}  // namespace avo::inline walls
