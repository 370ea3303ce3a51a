// SPDX-License-Identifier: Apache-2.0
// The three certificates behind one set of functions.
#include "certificate/certificate.h"

#include <algorithm>
#include <limits>

namespace avo {

void reserve_walls(std::size_t neighbors, std::size_t braking_steps, std::size_t most_walls,
                   CertificateWalls& walls) {
  walls.capsules.reserve(neighbors);
  walls.soft_stops.reserve(neighbors);
  walls.near.reserve(1, neighbors);
  // those of a pair are stored by whole packs
  const std::size_t steps = (braking_steps + kWallLanes - 1) / kWallLanes * kWallLanes;
  walls.trajectories.columns.reserve(std::min(neighbors * steps, most_walls));
  walls.trajectories.own_columns.reserve(std::min(braking_steps, most_walls));
}

void find_near(std::span<const Sensing> robots, const CertificateLaw& law,
               CertificateWalls& walls) {
  if (law.kind == Certificate::none || law.kind == Certificate::linear_soft_stop) return;
  const bool everyone = law.kind == Certificate::braking_trajectories;
  find_near(robots, everyone ? Whom::everyone : Whom::movers, law.step, walls.near);
}

void collect_walls(const Robot& robot, std::span<const Neighbor> neighbors,
                   const CertificateLaw& law, CertificateWalls& walls) {
  const Sensing alone{&robot, in_columns(neighbors, walls.seen), true};
  find_near({&alone, 1}, law, walls);
  collect_walls(alone, 0, law, walls);
}

void collect_walls(const Sensing& sensing, std::size_t i, const CertificateLaw& law,
                   CertificateWalls& walls) {
  const Robot& robot = *sensing.robot;
  walls.invariant = {std::numeric_limits<double>::infinity()};
  walls.trajectories.columns.count = 0;
  walls.trajectories.stays_at_rest = false;
  walls.capsules.clear();
  walls.soft_stops.clear();
  if (law.kind == Certificate::linear_soft_stop) {
    collect_soft_stops(robot, sensing.neighbors, law.step.time_step, law.soft_stop_time,
                       walls.soft_stops, walls.invariant);
  } else if (law.kind != Certificate::none) {
    collect_walls(robot, sensing.neighbors, walls.near, i, law.step, walls.trajectories,
                  walls.invariant);
  }
  if (law.kind == Certificate::stopping_capsules) {
    collect_capsules(robot, sensing.neighbors, law.step, walls.capsules, walls.invariant);
  }
}

bool admits(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
            CertificateWalls& walls) {
  if (law.kind == Certificate::linear_soft_stop) {
    return keeps(walls.soft_stops, soft_stop_velocity(robot.velocity, next_velocity,
                                                      law.step.time_step, law.soft_stop_time));
  }
  if (walls.demand_nothing()) return true;
  walls.path = follow(robot, next_velocity, law.step);
  const bool trajectories_kept = keeps(walls.path, law.step, walls.trajectories);
  if (walls.invariant.unknown || (walls.invariant.touched && walls.path.moving > 0)) return false;
  return trajectories_kept && keeps(walls.capsules, walls.path, law.step);
}

Vec2 backup_velocity(const Robot& robot, const CertificateLaw& law) {
  const double decrement = braking_decrement(robot.max_acceleration, law.step);
  // faster than v_max the soft stop would ask for more than a_max
  const bool softly = law.kind == Certificate::linear_soft_stop &&
                      law.step.time_step / law.soft_stop_time * norm(robot.velocity) <= decrement;
  return softly ? softly_braked(robot.velocity, law.step.time_step, law.soft_stop_time)
                : braked(robot.velocity, decrement);
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
  for (const SoftStopWall& wall : walls.soft_stops) {
    list.push_back({wall.neighbor, 0, wall.half_plane.normal, wall.half_plane.offset});
  }
}

}  // namespace avo
