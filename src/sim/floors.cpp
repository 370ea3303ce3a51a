// SPDX-License-Identifier: Apache-2.0
#include "sim/floors.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "sim/travels.h"

namespace avo::inline sim {

static_assert(std::is_nothrow_move_assignable_v<StaticWorld>);

std::vector<std::uint32_t> floors_of(const Fleet& fleet, const StaticWorld& statics) {
  std::vector<std::uint32_t> floors;
  if (statics.floors.size() < 2) return floors;
  for (const std::uint32_t slot : fleet.slot_of)
    floors.push_back(static_cast<std::uint32_t>(
        statics.floor_of(fleet.conduct[slot].layers).value_or(0)));  // parked robots heed none
  return floors;
}

std::uint32_t floor_for(World& world, LayerSet robot) {
  if (const auto known = world.statics.floor_of(robot)) return static_cast<std::uint32_t>(*known);
  StaticWorld& statics = world.statics;
  const std::size_t number = statics.floors.size();
  Floor floor = statics.floor_for(robot);
  Routes routes(route_rules_of(world.settings), floor.walls, world.movers.resting());
  std::vector<std::uint32_t> floors = world.floor;
  if (floors.empty()) floors.assign(world.fleet.size(), 0);
  statics.floors.reserve(number + 1), world.routes.reserve(number + 1);
  world.claims.reserve(number + 1);
  // nothing throws from here on
  statics.floors.push_back(std::move(floor)), world.routes.push_back(std::move(routes));
  world.claims.emplace_back();
  std::swap(world.floor, floors);
  world.changed = true;
  return static_cast<std::uint32_t>(number);
}

FloorRoutes routes_among(const World& world, const StaticWorld& statics) {
  FloorRoutes planned;
  planned.floor = floors_of(world.fleet, statics);
  planned.before.assign(statics.floors.size(), 0);
  for (std::size_t rank = planned.floor.size(); rank > 0; --rank)
    planned.before[planned.floor[rank - 1]] = world.floor_of(world.fleet.slot_of[rank - 1]);
  for (std::size_t k = 0; k < statics.floors.size(); ++k)
    planned.routes.emplace_back(route_rules_of(world.settings), statics.floors[k].walls,
                                world.movers.resting(), &world.routes[planned.before[k]]);
  if (has_routes(statics, planned.routes))
    planned.travels = plan_travels(planned.routes, world.fleet, planned.floor,
                                   world.settings.arrival_distance, world.travels);
  for (Routes& routes : planned.routes) routes.forget_before();
  return planned;
}

// A robot that has another end than before has not stood near it.
void adopt(World& world, FloorRoutes planned) noexcept {
  Fleet& fleet = world.fleet;
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) {
    if (fleet.is_parked(slot)) continue;
    const Vec2 goal = fleet.goal[slot];
    const auto rank = static_cast<std::size_t>(fleet.rank[slot]);
    const Vec2 end = planned.travels.empty() ? goal : planned.travels[rank].heads_for(goal);
    if (!(end == world.end_of(slot))) fleet.has_stood[slot] = 0;
  }
  for (std::size_t k = 0; k < planned.routes.size(); ++k) {
    const auto first = std::find(planned.before.begin(), planned.before.end(), planned.before[k]);
    if (first == planned.before.begin() + static_cast<std::ptrdiff_t>(k))  // what is moved away
      planned.routes[k].remember_passages(world.routes[planned.before[k]]);
  }
  world.routes = std::move(planned.routes);
  world.floor = std::move(planned.floor);
  world.travels = std::move(planned.travels);
  world.changed = world.has_new_goals = true;
}

void replace(World& world, StaticWorld statics) {
  FloorRoutes planned = routes_among(world, statics);
  world.claims.resize(std::max(world.claims.size(), statics.floors.size()));
  world.statics = std::move(statics);
  adopt(world, std::move(planned));
}

}  // namespace avo::inline sim
