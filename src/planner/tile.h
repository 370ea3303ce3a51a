// SPDX-License-Identifier: Apache-2.0
// Robots that are planned together: their states, neighbors and memory, and their decisions.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "avo/wall.h"
#include "core/robot_columns.h"

namespace avo::inline planner {

/// Allocates only while it grows.
struct Tile {
  RobotColumns robots;
  NeighborColumns neighbors;    ///< of all the robots, for each robot by distance and id
  std::vector<Detour*> detour;  ///< of each robot; updated
  /// filled, except next_velocity, which is known after the robot is moved
  std::vector<Plan*> plan;
  std::vector<std::span<const Wall>> walls;  ///< of each robot; none where no robot has any
  std::vector<std::uint32_t> slot;           ///< the caller's name of each robot
  /// set by steer(): 1 for a robot that maneuvers beside walls
  std::vector<std::uint8_t> maneuvers;
  bool remembers = true;  ///< whether `detour` is of the robots' last decisions
  /// whether the robots and their neighbors are known to be finite and in range
  bool trusted = true;

  std::span<const Wall> walls_of(std::size_t i) const {
    return walls.empty() ? std::span<const Wall>{} : walls[i];
  }
  void clear() {
    robots.clear();
    neighbors.clear();
    detour.clear();
    plan.clear();
    walls.clear();
    maneuvers.clear();
    slot.clear();
    remembers = true;
    trusted = true;
  }
  void reserve(std::size_t most_robots, std::size_t most_neighbors) {
    robots.reserve(most_robots);
    neighbors.reserve(most_neighbors);
    detour.reserve(most_robots);
    plan.reserve(most_robots);
    walls.reserve(most_robots);
    maneuvers.reserve(most_robots);
    slot.reserve(most_robots);
  }
};

}  // namespace avo::inline planner
