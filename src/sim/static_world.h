// SPDX-License-Identifier: Apache-2.0
// Static obstacles of a simulation, and their walls.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "guidance/wall_needs.h"
#include "sim/fleet.h"
#include "walls/wall_grid.h"

namespace avo::inline sim {

/// Everything that does not move. Steps do not read it where there are no walls.
struct StaticWorld {
  std::vector<ObstacleId> id;  // ascending
  std::vector<StaticObstacle> obstacles;
  std::uint64_t next_id = 0;
  std::vector<Wall> parked;  // discs of robots
  std::vector<Wall> walls;   // of all obstacles, in their order, and parked robots
  std::uint64_t hash = 0;    // of ids and obstacles
  WallGrid grid;
  std::optional<WallNeeds> needs;  // the needs that the grid serves; unset: none is built yet

  StaticWorld(std::vector<StaticObstacle> obstacles, std::vector<ObstacleId> id,
              std::uint64_t next_id, std::vector<Wall> parked);
};

/// The obstacles of a scene, by their place in it, and its parked robots.
StaticWorld static_world(const Scenario& scenario);

}  // namespace avo::inline sim
