// SPDX-License-Identifier: Apache-2.0
// Static obstacles of a simulation, and the walls that they are made of.
#pragma once
#include <cstdint>
#include <vector>

#include "avo/simulation.h"
#include "certificate/wall_constraints.h"
#include "walls/wall_grid.h"

namespace avo {

/// What does not move. Nobody looks at it where there are no obstacles.
struct StaticWorld {
  std::vector<ObstacleId> id;  // ascending
  std::vector<StaticObstacle> obstacles;
  std::uint64_t next_id = 0;
  std::vector<Wall> walls;  // of all obstacles, in their order
  std::uint64_t hash = 0;   // of ids and obstacles
  WallGrid grid;
  // of robots, that the grid has been built for
  double reach = -1.0;  // m
  WallRounding rounding;

  StaticWorld(std::vector<StaticObstacle> obstacles, std::vector<ObstacleId> id,
              std::uint64_t next_id);
};

/// The obstacles of a scene, by their place in it.
StaticWorld static_world(std::vector<StaticObstacle> obstacles);

}  // namespace avo
