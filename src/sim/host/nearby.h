// SPDX-License-Identifier: Apache-2.0
// What is where at present: discs of robots and movers, and walls, for queries of the host.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "navigation/clearance_grid.h"

namespace avo::inline sim {

struct World;

/// The present discs in one grid, the static walls in another one, which lasts longer.
struct Nearby {
  ClearanceGrid discs;                  // robots by rank, then moving obstacles
  std::size_t robots = 0;               // of the discs
  ClearanceGrid walls;                  // of static obstacles
  std::vector<std::uint32_t> obstacle;  // of each wall, index into static obstacles
  bool has_discs = false, has_walls = false;
};

/// Makes what is not there yet: all of it, or the walls alone.
void look_around(const World& world, Nearby& nearby);
void look_at_walls(const World& world, Nearby& nearby);

/// Ranks of robots with discs within `radius` of the point, the nearest disc first.
std::vector<std::size_t> robots_within(const Nearby& nearby, Vec2 center, double radius);
/// Ranks of the robots with the discs nearest to the point, nearest first.
std::vector<std::size_t> nearest_robots(const Nearby& nearby, Vec2 position, std::size_t count);
/// Returns whether a disc there would touch nothing, and would not be where a Fill excludes it.
/// layers, here and below: see Simulation::is_free().
bool is_free(const World& world, const Nearby& nearby, Vec2 position, double radius,
             LayerSet layers);
/// The first thing that a disc touches which moves straight from one point to the other.
std::optional<Simulation::Hit> first_hit(const World& world, const Nearby& nearby, Vec2 from,
                                         Vec2 to, double radius, LayerSet layers);

/// Returns whether no wall stops a disc that moves straight from one point to the other.
bool is_in_sight(const World& world, const Nearby& nearby, Vec2 from, Vec2 to, double radius,
                 LayerSet layers);

}  // namespace avo::inline sim
