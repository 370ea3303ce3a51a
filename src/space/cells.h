// SPDX-License-Identifier: Apache-2.0
// Cubic cells of space, in a table of bounded size: who may be within the sensing radius.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/space/robot.h"
#include "spatial/cell_sort.h"

namespace avo::space {

class SpaceCells {
 public:
  /// side: m, of a cell, at least the radius of all searches.
  explicit SpaceCells(double side) : per_meter_(1.0 / side) {}

  /// Sorts the robots by cell. Allocates only while their number grows.
  void sort(std::span<const Robot> robots);

  /// Appends the indices of all robots in the cells around a place, in no particular order; some
  /// may be farther than the side.
  void collect(Vec3 place, std::vector<std::uint32_t>& found) const;

 private:
  [[nodiscard]] std::int64_t cell(double coordinate) const;
  [[nodiscard]] std::uint32_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const;

  double per_meter_;
  std::uint32_t mask_ = 0;
  std::vector<std::uint32_t> keys_;
  CellSort sorted_;
};

}  // namespace avo::space
