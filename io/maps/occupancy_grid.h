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
  std::vector<bool> free;              ///< row by row, from the top; other cells are blocked
  double cell = 1.0;                   ///< m, side of a cell
  avo::Vec2 origin;                    ///< m, lower left corner
  double yaw = 0.0;                    ///< rad, the rotation of the whole map about its origin

  /// Returns whether the cell is free; cells outside the map are not.
  [[nodiscard]] bool is_free(std::int64_t column, std::int64_t row) const {
    return column >= 0 && column < width && row >= 0 && row < height &&
           free[static_cast<std::size_t>(row * width + column)];
  }
  /// Returns the point so many cells to the right of the origin, and up.
  [[nodiscard]] avo::Vec2 point(double right, double up) const;
  /// Returns the center of a cell.
  [[nodiscard]] avo::Vec2 center(std::int64_t column, std::int64_t row) const {
    return point(static_cast<double>(column) + 0.5, static_cast<double>(height - row) - 0.5);
  }
};

/// A corner of cells: its distance in cells to the right of the lower left corner of the map, and
/// up.
struct Corner {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const Corner&, const Corner&) = default;
};
/// A closed chain of corners with free space to the left.
using Contour = std::vector<Corner>;

/// Returns the borders between free and blocked cells. Free cells that meet only at a corner stay
/// apart. Returns none if there are more than `most` corners.
std::optional<std::vector<Contour>> contours(const OccupancyGrid& grid, std::size_t most);

std::vector<avo::Chain> chains_of(const OccupancyGrid& grid, const std::vector<Contour>& contours);

}  // namespace avo_io
