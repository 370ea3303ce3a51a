// SPDX-License-Identifier: Apache-2.0
// Robots that are planned together: their neighbors lie side by side.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/planner.h"
#include "core/neighbor_columns.h"
#include "planner/together.h"

namespace avo {

/// What robots know and sense, and where their decisions go. Allocates only while it grows.
struct Tile {
  std::vector<Robot> robots;          ///< those of deciding
  NeighborColumns neighbors;          ///< of all the robots, each by distance and id
  std::vector<std::size_t> first{0};  ///< of robot i: [first[i], first[i + 1]), into neighbors
  std::vector<Deciding> deciding;     ///< what each remembers and decides, by plan_together()
  bool trusted = true;                ///< all neighbors are known to be finite and in range

  void clear();
  [[nodiscard]] std::size_t size() const { return deciding.size(); }
  [[nodiscard]] Neighbors neighbors_of(std::size_t i) const {
    return {&neighbors, first[i], first[i + 1] - first[i]};
  }
  void reserve(std::size_t most_robots, std::size_t most_neighbors);
};

}  // namespace avo
