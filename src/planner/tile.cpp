// SPDX-License-Identifier: Apache-2.0
#include "planner/tile.h"

namespace avo {

void Tile::clear() {
  robots.clear();
  neighbors.clear();
  detour.clear();
  plan.clear();
  slot.clear();
  trusted = true;
}

void Tile::reserve(std::size_t most_robots, std::size_t most_neighbors) {
  robots.reserve(most_robots);
  neighbors.reserve(most_neighbors);
  detour.reserve(most_robots);
  plan.reserve(most_robots);
  slot.reserve(most_robots);
}

}  // namespace avo
