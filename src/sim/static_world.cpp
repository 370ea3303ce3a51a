// SPDX-License-Identifier: Apache-2.0
#include "sim/static_world.h"

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
    for (const Chain& chain : obstacle.chains) {
      hash = mixed(mixed(hash, chain.points.size()), chain.closed ? 1 : 0);
      for (const Vec2 point : chain.points) mix(point.x), mix(point.y);
    }
  }
  return hash;
}

}  // namespace

StaticWorld::StaticWorld(std::vector<StaticObstacle> listed, std::vector<ObstacleId> ids,
                         std::uint64_t next, std::vector<Wall> discs)
    : id(std::move(ids)),
      obstacles(std::move(listed)),
      next_id(next),
      parked(std::move(discs)),
      walls(walls_of(obstacles)),
      hash(hash_of(*this)) {
  walls.insert(walls.end(), parked.begin(), parked.end());
}

StaticWorld static_world(const Scenario& scenario) {
  std::vector<ObstacleId> ids;
  for (std::size_t k = 0; k < scenario.obstacles.size(); ++k) ids.push_back({k});
  const std::uint64_t next = ids.size();
  return {scenario.obstacles, std::move(ids), next, parked_discs(scenario.robots)};
}

}  // namespace avo::inline sim
