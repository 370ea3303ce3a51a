// SPDX-License-Identifier: Apache-2.0
// The floors of a simulation: robots of one floor heed the same static obstacles, and have routes
// around them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/world.h"

namespace avo::inline sim {

/// The floors of robots in a static world that has them, by rank; empty where there is one floor.
std::vector<std::uint32_t> floors_of(const Fleet& fleet, const StaticWorld& statics);
/// The index of the floor of robots in these layers. It is made if there is none yet.
std::uint32_t floor_for(World& world, LayerSet robot);

/// The maps of all floors of a static world, and the robots' routes there.
struct FloorRoutes {
  std::vector<Routes> routes;
  std::vector<std::uint32_t> floor;  // see World
  std::vector<Travel> travels;
  std::vector<std::size_t> before;  // of each floor: the present floor of its first robot
};
/// The routes of the present fleet, which continue where they can.
FloorRoutes routes_among(const World& world, const StaticWorld& statics);

/// Takes the routes in place of the present ones.
void adopt(World& world, FloorRoutes planned) noexcept;
/// Replaces the static world for the same fleet.
void replace(World& world, StaticWorld statics);

}  // namespace avo::inline sim
