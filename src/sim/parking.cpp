// SPDX-License-Identifier: Apache-2.0
// Parks a robot where it stands, or sets a parked robot free, between two steps.
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/ranges.h"
#include "robots/model.h"
#include "sim/edits.h"
#include "sim/floors.h"
#include "sim/scene/edit_checks.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

// The discs of parked robots, in the order of their ids, once this robot is parked or free.
std::vector<Wall> discs_with(const Fleet& fleet, std::size_t changed, bool is_parked) {
  std::vector<Wall> discs;
  for (const std::uint32_t slot : fleet.slot_of) {
    if (slot == changed ? is_parked : fleet.conduct[slot].parked)
      discs.push_back({fleet.position[slot], fleet.position[slot], fleet.traits[slot].radius});
  }
  return discs;
}

void check(World& world, std::size_t slot, const RobotSetup& changed) {
  const RobotId robot = world.fleet.id[slot];
  const double speed = norm(world.fleet.velocity[slot]);
  if (world.fleet.has_clocks)
    refuse(name_of(robot) + ": parked", "a change while clocks are free", "the same");
  if (speed > 0.0)
    refuse(name_of(robot) + ": parked", "a robot at " + text(speed) + " m/s", "one at rest");
  check_values(world, changed, robot, world.statics.has_walls);
  if (!world.kinds) world.kinds.emplace(world.fleet);
  look_around_starts(world);
  if (changed.parked) {
    const Vec2 center = world.fleet.position[slot];
    check_newly_static(world, {{{{center}, false}}, disc_radius(changed)}, name_of(robot), robot);
  } else {
    check_company(world, changed, robot);
  }
  check_start(world, changed, robot);
}

// The routes of all robots once this robot is parked or free.
Routes routes_with(const World& world, const StaticWorld& statics, std::size_t slot,
                   const RobotSetup& changed) {
  Routes routes = routes_among(world, statics);
  const auto rank = static_cast<std::size_t>(world.fleet.rank[slot]);
  const std::size_t floor = changed.parked ? 0 : statics.floor_of(changed.layers).value_or(0);
  if (!routes.floor.empty()) routes.floor[rank] = static_cast<std::uint32_t>(floor);
  if (routes.travels.empty()) return routes;
  routes.travels[rank] = {};
  if (!changed.parked)
    routes.travels[rank] = routes.ways[floor].plan(way_radius(changed.model, disc_radius(changed)),
                                                   world.fleet.position[slot], changed.goal,
                                                   arrival_distance_of(world.settings, changed));
  return routes;
}

}  // namespace

void park_or_free(World& world, std::size_t slot, RobotSetup changed) {
  Fleet& fleet = world.fleet;
  changed.goal = changed.position;
  check(world, slot, changed);
  const double sensing_radius = sensing_radius_with(world, changed);
  const OwnPace pace = world.pace_of(changed, true);
  std::vector<LayerSet> layers = layers_of(fleet);
  if (!changed.parked) layers.push_back(changed.layers);
  const StaticWorld& now = world.statics;
  StaticWorld statics(now.obstacles, now.id, now.next_id, discs_with(fleet, slot, changed.parked),
                      layers);
  Routes routes = routes_with(world, statics, slot, changed);
  world.claims.resize(std::max(world.claims.size(), statics.floors.size()));
  fleet.change(slot, changed, pace);
  // nothing throws from here on
  fleet.goal[slot] = changed.goal;
  fleet.detour[slot] = {}, fleet.plan[slot] = {};
  fleet.has_stood[slot] = 0, fleet.applied_acceleration[slot] = 0.0;
  if (!fleet.told.empty()) fleet.told[static_cast<std::size_t>(fleet.rank[slot])].reset();
  world.kinds.reset();
  forget(world.bystanders);
  world.statics = std::move(statics);
  world.sensing_radius = sensing_radius;
  adopt(world, std::move(routes));
}

}  // namespace avo::inline sim
