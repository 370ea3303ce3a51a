// SPDX-License-Identifier: Apache-2.0
#include "sim/columns/static_world.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "core/hash.h"

namespace avo::inline sim {
namespace {

std::uint64_t hash_of(const StaticWorld& statics) {
  std::uint64_t hash = 0;
  const auto mix = [&hash](double value) {
    hash = mixed(hash, std::bit_cast<std::uint64_t>(value));
  };
  for (std::size_t k = 0; k < statics.id.size(); ++k) {
    const StaticObstacle& obstacle = statics.obstacles[k];
    hash = mixed(mixed(hash, statics.id[k].value), obstacle.chains.size());
    mix(obstacle.radius);
    if (!(obstacle.layers == kAllLayers)) hash = mixed(hash, obstacle.layers.bits);
    for (const Chain& chain : obstacle.chains) {
      hash = mixed(mixed(hash, chain.points.size()), chain.closed ? 1 : 0);
      for (const Vec2 point : chain.points) mix(point.x), mix(point.y);
    }
  }
  return hash;
}

}  // namespace

StaticWorld::StaticWorld(std::vector<StaticObstacle> listed, std::vector<ObstacleId> ids,
                         std::uint64_t next, std::vector<Wall> discs,
                         std::span<const LayerSet> robots)
    : id(std::move(ids)),
      obstacles(std::move(listed)),
      next_id(next),
      parked(std::move(discs)),
      hash(hash_of(*this)),
      telling(telling_layers(obstacles)) {
  for (const LayerSet robot : robots)
    if (!floor_of(robot)) floors.push_back(floor_for(robot));
  if (floors.empty()) floors.push_back(floor_for(RobotSetup{}.layers));
  has_walls = !parked.empty() ||
              std::any_of(obstacles.begin(), obstacles.end(),
                          [](const StaticObstacle& obstacle) { return !obstacle.chains.empty(); });
}

std::optional<std::size_t> StaticWorld::floor_of(LayerSet robot) const {
  const LayerSet layers{robot.bits & telling.bits};
  for (std::size_t k = 0; k < floors.size(); ++k)
    if (floors[k].layers == layers) return k;
  return std::nullopt;
}

Floor StaticWorld::floor_for(LayerSet robot) const {
  Floor floor{.layers = {robot.bits & telling.bits}, .walls = {}, .grid = {}, .needs = {}};
  for (const StaticObstacle& obstacle : obstacles) {
    if (!heeds(robot, obstacle)) continue;
    const std::vector<Wall> own = walls_of(std::span(&obstacle, 1));
    floor.walls.insert(floor.walls.end(), own.begin(), own.end());
  }
  floor.walls.insert(floor.walls.end(), parked.begin(), parked.end());
  return floor;
}

LayerSet telling_layers(std::span<const StaticObstacle> obstacles) {
  LayerSet telling;
  for (const StaticObstacle& obstacle : obstacles)
    if (!(obstacle.layers == kAllLayers)) telling.bits |= obstacle.layers.bits;
  return telling;
}

StaticWorld static_world(const Scenario& scenario) {
  std::vector<ObstacleId> ids;
  for (std::size_t k = 0; k < scenario.obstacles.size(); ++k) ids.push_back({k});
  const std::uint64_t next = ids.size();
  std::vector<LayerSet> layers;
  for (const RobotSetup& robot : scenario.robots)
    if (!is_parked(robot)) layers.push_back(robot.layers);
  return {scenario.obstacles, std::move(ids), next, parked_discs(scenario.robots), layers};
}

std::vector<LayerSet> layers_of(const Fleet& fleet) {
  std::vector<LayerSet> layers;
  for (const std::uint32_t slot : fleet.slot_of)
    if (!fleet.is_parked(slot)) layers.push_back(fleet.conduct[slot].layers);
  return layers;
}

}  // namespace avo::inline sim
