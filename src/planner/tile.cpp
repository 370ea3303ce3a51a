// SPDX-License-Identifier: Apache-2.0
#include "planner/tile.h"

namespace avo {

void Tile::clear() {
  neighbors.clear();
  first.assign(1, 0);
  deciding.clear();
  trusted = true;
}

std::span<const Neighbor> Tile::list_neighbors_of(std::size_t i) {
  listed.clear();
  for (std::size_t k = first[i]; k < first[i + 1]; ++k) listed.push_back(neighbors[k]);
  return listed;
}

void Tile::reserve(std::size_t most_robots, std::size_t most_neighbors) {
  robots.reserve(most_robots);
  neighbors.reserve(most_neighbors);
  first.reserve(most_robots + 1);
  deciding.reserve(most_robots);
}

void plan_tile(const Planner& planner, Tile& tile, PlanWorkspace& workspace, StageClock& clock) {
  if (planner.options().method == Method::velocity_obstacle) {
    for (std::size_t i = 0; i < tile.size(); ++i) {
      *tile.deciding[i].plan = planner.plan(tile.robots[i], tile.list_neighbors_of(i), workspace);
    }
    return clock.lap(Stage::program);
  }
  plan_together(planner, tile.deciding, workspace, clock);
}

}  // namespace avo
