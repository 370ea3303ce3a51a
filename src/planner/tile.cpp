// SPDX-License-Identifier: Apache-2.0
#include "planner/tile.h"

namespace avo {

void Tile::clear() {
  robots.clear();
  neighbors.clear();
  first.assign(1, 0);
  detours.clear();
  plans.clear();
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
  detours.reserve(most_robots);
  plans.reserve(most_robots);
  deciding.reserve(most_robots);
}

void plan_tile(const Planner& planner, Tile& tile, PlanWorkspace& workspace, StageClock& clock) {
  tile.plans.resize(tile.size());
  if (planner.options().method == Method::velocity_obstacle) {
    for (std::size_t i = 0; i < tile.size(); ++i) {
      tile.plans[i] = planner.plan(tile.robots[i], tile.list_neighbors_of(i), workspace);
    }
    return clock.lap(Stage::program);
  }
  tile.deciding.clear();
  for (std::size_t i = 0; i < tile.size(); ++i) {
    tile.deciding.push_back(
        {{&tile.robots[i], tile.neighbors_of(i), tile.trusted}, &tile.detours[i], &tile.plans[i]});
  }
  plan_together(planner, tile.deciding, workspace, clock);
}

}  // namespace avo
