// SPDX-License-Identifier: Apache-2.0
#include "planner/tile.h"

namespace avo {

void Tile::clear() {
  neighbors.clear();
  first.assign(1, 0);
  deciding.clear();
  trusted = true;
}

void Tile::reserve(std::size_t most_robots, std::size_t most_neighbors) {
  robots.reserve(most_robots);
  neighbors.reserve(most_neighbors);
  first.reserve(most_robots + 1);
  deciding.reserve(most_robots);
}

}  // namespace avo
