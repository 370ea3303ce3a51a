// SPDX-License-Identifier: Apache-2.0
// Static obstacles of a simulation, and the walls of each of its floors.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "guidance/wall_needs.h"
#include "sim/columns/fleet.h"
#include "walls/wall_grid.h"

namespace avo::inline sim {

/// The walls that robots of some layers heed. Without layers of obstacles there is one floor.
struct Floor {
  LayerSet layers;          // of its robots, of those that tell obstacles apart
  std::vector<Wall> walls;  // of the obstacles that they heed, in their order, and parked robots
  WallGrid grid;
  std::optional<WallNeeds> needs;  // the needs that the grid serves; unset: none is built yet
};

/// Everything that does not move. Steps do not read it where there are no walls.
struct StaticWorld {
  std::vector<ObstacleId> id;  // ascending
  std::vector<StaticObstacle> obstacles;
  std::uint64_t next_id = 0;
  std::vector<Wall> parked;  // discs of robots
  bool has_walls = false;    // of obstacles or parked robots
  std::uint64_t hash = 0;    // of ids and obstacles
  LayerSet telling;          // see telling_layers()
  std::vector<Floor> floors;

  /// robots: their layers; those of each kind of robot suffice.
  StaticWorld(std::vector<StaticObstacle> obstacles, std::vector<ObstacleId> id,
              std::uint64_t next_id, std::vector<Wall> parked, std::span<const LayerSet> robots);

  /// Returns whether there is a floor for robots in these layers, by its index.
  [[nodiscard]] std::optional<std::size_t> floor_of(LayerSet robot) const;
  /// The floor of such robots, to be added.
  [[nodiscard]] Floor floor_for(LayerSet robot) const;
};

/// The layers by which robots heed some of the obstacles and not others. Robots that are in the
/// same of these layers heed the same obstacles.
LayerSet telling_layers(std::span<const StaticObstacle> obstacles);

/// The obstacles of a scene, by their place in it, and its parked robots.
StaticWorld static_world(const Scenario& scenario);

/// The layers of all robots of the fleet that are not parked, by rank.
std::vector<LayerSet> layers_of(const Fleet& fleet);

}  // namespace avo::inline sim
