// SPDX-License-Identifier: Apache-2.0
#include "sim/static_world.h"

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
    for (const Chain& chain : obstacle.chains) {
      hash = mixed(mixed(hash, chain.points.size()), chain.closed ? 1 : 0);
      for (const Vec2 point : chain.points) mix(point.x), mix(point.y);
    }
  }
  return hash;
}

}  // namespace

void WallNeeds::include(const RobotTraits& robot, double stray, double speed, const StepLaw& law) {
  const double radius = robot.radius, max_speed = robot.max_speed;
  const Ability ability = ability_of(robot);
  const WallRounding own = wall_rounding(radius, max_speed, ability, law);
  rounding = {std::max(rounding.steps, own.steps), std::max(rounding.lengths, own.lengths)};
  const double top_speed = std::max(max_speed, speed);
  reach = std::max(
      reach, radius + stray + wall_reach(top_speed, max_speed, planned_ability_of(robot), law));
}

bool WallNeeds::cover(const WallNeeds& needs) const {
  return needs.reach <= reach && needs.rounding.steps <= rounding.steps &&
         needs.rounding.lengths <= rounding.lengths;
}

WallGrid grid_of(std::span<const Wall> walls, const WallNeeds& needs) {
  constexpr double kRounding = 0x1p-20;  // of a length, more than the grid's own arithmetic hides
  std::vector<double> within;
  within.reserve(walls.size());
  for (const Wall& wall : walls) {
    const double exact = needs.reach + wall.radius + wall_margin(wall, needs.rounding);
    within.push_back(exact * (1.0 + kRounding));
  }
  WallGrid grid;
  grid.build(walls, within);
  return grid;
}

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
