// SPDX-License-Identifier: Apache-2.0
// Finds the walls near a robot.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "spatial/point_grid.h"

namespace avo::inline metrics {

/// Walls in pieces with their middles in a grid that fits the walls and the distance.
class WallSearch {
 public:
  explicit WallSearch(std::vector<Wall> walls = {});
  [[nodiscard]] std::span<const Wall> walls() const { return walls_; }

  /// Prepares searches within that distance, m, >= 0. It costs time if the distance has changed
  /// much.
  void prepare(double distance);
  /// All walls with a middle line within the prepared distance, by ascending index, and others.
  std::span<const std::size_t> near(Vec2 position);

 private:
  void cut(double distance);

  std::vector<Wall> walls_;
  double total_length_ = 0.0;         // m
  double prepared_ = -1.0;            // m, negative: for none
  std::vector<std::size_t> wall_of_;  // by piece
  PointGrid grid_;
  SearchScratch scratch_;
  std::vector<std::size_t> near_;
};

}  // namespace avo::inline metrics
