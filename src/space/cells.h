// SPDX-License-Identifier: Apache-2.0
// Cubic cells of space, in a table of bounded size: the robots that may be within the sensing
// radius.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/space/robot.h"
#include "space/bodies.h"
#include "spatial/cell_sort.h"

namespace avo::space {

/// The table has as many cells along each axis as a power of two, and begins anew behind the last
/// one. Cells that share a slot are farther apart than a search reaches: their robots fail the test
/// of distance, and no robot is found twice. So a distant outlier costs nothing.
class SpaceCells {
 public:
  /// The cells of a row along x are consecutive, except where the row begins anew. So many runs
  /// contain all cells that a search reads.
  static constexpr std::size_t kMostSpan = 5;  // cells along an axis
  using Runs = std::array<Run, 2 * kMostSpan * kMostSpan + 1>;

  /// radius: m, of all searches, > 0.
  explicit SpaceCells(double radius);

  /// Sorts the robots by cell. Allocates only while their number grows.
  void sort(std::span<const Robot> robots);
  /// The indices of the robots in the order of their cells: the places that runs count.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return sorted_.order; }

  /// The places of all robots within the radius, and of some others; none is in two runs. Returns
  /// the number of runs, which are not empty.
  std::size_t around(Vec3 place, Runs& runs) const;

 private:
  [[nodiscard]] std::int64_t cell(double coordinate) const;
  [[nodiscard]] std::size_t wrapped(std::int64_t its_cell, std::size_t axis) const;
  [[nodiscard]] std::size_t row(std::int64_t y, std::int64_t z) const;  // its first slot
  [[nodiscard]] double away(double coordinate, std::int64_t its_cell) const;
  void choose_sizes(std::span<const Robot> robots);

  double radius_, side_, per_meter_;
  std::array<std::size_t, 3> bits_{};  // of the number of cells along each axis
  std::vector<std::uint32_t> keys_;
  CellSort sorted_;
};

}  // namespace avo::space
