// SPDX-License-Identifier: Apache-2.0
// A map of square cells, and the walls around its blocked ones.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "avo/wall.h"

namespace avo_io {

struct OccupancyGrid {
  std::int64_t width = 0, height = 0;  ///< cells
  std::vector<bool> free;              ///< row by row, the first is the top; others are blocked
  double cell = 1.0;                   ///< m, side of a cell
  avo::Vec2 origin;                    ///< m, lower left corner
  double yaw = 0.0;                    ///< rad, of the whole map about its origin

  /// Outside of the map nothing is free.
  [[nodiscard]] bool is_free(std::int64_t column, std::int64_t row) const {
    return column >= 0 && column < width && row >= 0 && row < height &&
           free[static_cast<std::size_t>(row * width + column)];
  }
  /// The point so many cells to the right of the origin, and up.
  [[nodiscard]] avo::Vec2 point(double right, double up) const;
  /// The center of a cell.
  [[nodiscard]] avo::Vec2 center(std::int64_t column, std::int64_t row) const {
    return point(static_cast<double>(column) + 0.5, static_cast<double>(height - row) - 0.5);
  }
};

/// The borders between free and blocked cells as closed chains of corners, free space to the left.
/// Free cells that meet at a corner alone stay apart. None where there are more than `most`
/// corners.
std::optional<std::vector<avo::Chain>> contours(const OccupancyGrid& grid, std::size_t most);

}  // namespace avo_io
