// SPDX-License-Identifier: Apache-2.0
// Robots that are planned together: what they know, sense and remember, and what they decide.
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
  NeighborColumns neighbors;    ///< of all the robots, each one's by distance and id
  std::vector<Detour*> detour;  ///< of each robot; updated
  std::vector<Plan*> plan;      ///< filled, but for next_velocity: moving the robot tells that
  std::vector<std::span<const Wall>> walls;  ///< of each robot; none where no robot has any
  std::vector<std::uint32_t> slot;           ///< what whoever fills the tile calls each robot
  std::vector<std::uint8_t> maneuvers;  ///< by steer(): 1 of a robot that maneuvers beside walls
  bool remembers = true;                ///< what is in `detour` is of the robots' last decisions
  bool trusted = true;  ///< the robots and their neighbors are known to be finite and in range

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
