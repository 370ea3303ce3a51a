// SPDX-License-Identifier: Apache-2.0
// Which walls are near a robot.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "neighbors/uniform_grid.h"

namespace avo::inline metrics {

/// Walls in pieces, whose middles stand in a grid: it fits the walls and the distance.
class WallSearch {
 public:
  explicit WallSearch(std::vector<Wall> walls = {});
  [[nodiscard]] std::span<const Wall> walls() const { return walls_; }

  /// For searches within that distance, m, >= 0. Costs time where it has changed much.
  void prepare(double distance);
  /// All walls whose middle line is within the distance that it is prepared for, by ascending
  /// index, and others.
  std::span<const std::size_t> near(Vec2 position);

 private:
  void cut(double distance);

  std::vector<Wall> walls_;
  double total_length_ = 0.0;         // m
  double prepared_ = -1.0;            // m, negative: for none
  std::vector<std::size_t> wall_of_;  // by piece
  UniformGrid grid_;
  SearchScratch scratch_;
  std::vector<std::size_t> near_;
};

}  // namespace avo::inline metrics
