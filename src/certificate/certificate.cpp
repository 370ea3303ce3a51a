// SPDX-License-Identifier: Apache-2.0
// Both certificates behind one set of functions.
#include "certificate/certificate.h"

#include <algorithm>
#include <limits>

namespace avo {

void reserve_walls(std::size_t neighbors, std::size_t braking_steps, std::size_t most_walls,
                   CertificateWalls& walls) {
  walls.capsules.reserve(neighbors);
  walls.near.reserve(1, neighbors);
  walls.trajectories.waiting.reserve(neighbors);
  // those of a pair are stored by whole packs
  const std::size_t steps = (braking_steps + kWallLanes - 1) / kWallLanes * kWallLanes;
  walls.trajectories.columns.reserve(std::min(neighbors * steps, most_walls));
  walls.trajectories.own_columns.reserve(std::min(braking_steps, most_walls));
}

void find_near(const RobotColumns& robots, const CertificateLaw& law, CertificateWalls& walls) {
  if (law.kind == Certificate::none) return;
  const bool everyone = law.kind == Certificate::braking_trajectories;
  find_near(robots, everyone ? Whom::everyone : Whom::movers, law.step, walls.near);
}

void collect_walls(const Robot& robot, std::span<const Neighbor> neighbors,
                   const CertificateLaw& law, CertificateWalls& walls) {
  walls.alone.reserve(1);
  walls.alone.clear();
  walls.alone.add(robot, in_columns(neighbors, walls.seen));
  find_near(walls.alone, law, walls);
  begin_walls(robot, walls.alone.neighbors[0], 0, law, walls);
  collect_waiting(law.step, walls.trajectories, walls.invariant);
}

void begin_walls(const Robot& robot, const Neighbors& neighbors, std::size_t i,
                 const CertificateLaw& law, CertificateWalls& walls) {
  walls.invariant = {std::numeric_limits<double>::infinity()};
  walls.trajectories.columns.count = 0;
  walls.trajectories.stays_at_rest = false;
  walls.trajectories.waiting.clear();
  walls.capsules.clear();
  if (law.kind == Certificate::none) return;
  begin_walls(robot, neighbors, walls.near, i, law.step, walls.trajectories, walls.invariant);
  if (law.kind == Certificate::stopping_capsules) {
    collect_capsules(robot, neighbors, law.step, walls.capsules, walls.invariant);
  }
}

bool admits(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
            CertificateWalls& walls) {
  if (walls.demand_nothing()) return true;
  walls.path = follow(robot, next_velocity, law.step);
  collect_refusing(robot, walls.path, law.step, walls.trajectories, walls.invariant);
  const bool trajectories_kept = keeps(walls.path, law.step, walls.trajectories);
  if (walls.invariant.unknown || (walls.invariant.touched && walls.path.moving > 0)) return false;
  return trajectories_kept && keeps(walls.capsules, walls.path, law.step);
}

Vec2 backup_velocity(const Robot& robot, const CertificateLaw& law) {
  return braked(robot.velocity, braking_decrement(robot.max_acceleration, law.step));
}

void list_walls(const CertificateWalls& walls, Vec2 position, std::vector<CertificateWall>& list) {
  list.clear();
  for (std::size_t k = 0; k < walls.trajectories.columns.count; ++k) {
    if (!walls.trajectories.columns.is_wall(k)) continue;
    const TrajectoryWall wall = wall_at(walls.trajectories.columns, k);
    list.push_back({wall.neighbor, wall.interval, wall.normal, wall.bound});
  }
  for (const CapsuleWall& wall : walls.capsules) {
    list.push_back({wall.neighbor, 0, wall.normal, wall.offset + dot(wall.normal, position)});
  }
}

}  // namespace avo
