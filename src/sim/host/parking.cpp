// SPDX-License-Identifier: Apache-2.0
// Parked robots between two steps: a host adds or removes one, parks a robot where the robot
// stands, or sets it free.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/ranges.h"
#include "robots/model.h"
#include "sim/floors.h"
#include "sim/host/edits.h"
#include "sim/scene/edit_checks.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

// The same obstacles beside other parked robots, for robots in these layers.
StaticWorld beside(const World& world, std::vector<Wall> parked, std::span<const LayerSet> layers) {
  const StaticWorld& statics = world.statics;
  return {statics.obstacles, statics.id, statics.next_id, std::move(parked), layers};
}

// Refuses the wall of a robot that parks, if another robot could not stop before the wall. own: the
// robot, if it is there already.
void check_wall(World& world, const Wall& wall, RobotId robot, std::optional<RobotId> own) {
  const std::vector<Vec2> ends =
      wall.a == wall.b ? std::vector{wall.a} : std::vector{wall.a, wall.b};
  check_newly_static(world, {{{ends, false}}, wall.radius, Fill::none}, name_of(robot), own);
}

// The robot's wall at its present place; none if the robot is set free.
std::optional<Wall> wall_of(const Fleet& fleet, std::size_t slot, const RobotSetup& changed) {
  if (!is_parked(changed)) return std::nullopt;
  return parked_wall(changed.model, fleet.position[slot], disc_radius(changed),
                     fleet.heading[slot]);
}

void check(World& world, std::size_t slot, const RobotSetup& changed,
           const std::optional<Wall>& wall) {
  const RobotId robot = world.fleet.id[slot];
  const double speed = norm(world.fleet.velocity[slot]);
  if (world.fleet.has_clocks)
    refuse(name_of(robot) + ": behavior", "a change to or from parked while clocks are free",
           "the same");
  if (speed > 0.0)
    refuse(name_of(robot) + ": behavior", "parked at " + text(speed) + " m/s", "parked at rest");
  check_values(world, changed, robot, world.statics.has_walls);
  if (!world.kinds) world.kinds.emplace(world.fleet);
  look_around_starts(world);
  if (wall)
    check_wall(world, *wall, robot, robot);
  else
    check_company(world, changed, robot);
  check_start(world, changed, robot);
}

// The routes of all robots once this robot is parked or free.
FloorRoutes routes_with(const World& world, const StaticWorld& statics, std::size_t slot,
                        const RobotSetup& changed) {
  FloorRoutes planned = routes_among(world, statics);
  const auto rank = static_cast<std::size_t>(world.fleet.rank[slot]);
  const std::size_t floor = is_parked(changed) ? 0 : statics.floor_of(changed.layers).value_or(0);
  if (!planned.floor.empty()) planned.floor[rank] = static_cast<std::uint32_t>(floor);
  if (planned.travels.empty()) return planned;
  planned.travels[rank] = {};
  if (!is_parked(changed))
    planned.travels[rank] = planned.routes[floor].plan(
        route_radius(changed.model, disc_radius(changed)), world.fleet.position[slot], changed.goal,
        arrival_distance_of(world.settings, changed));
  return planned;
}

}  // namespace

void add_parked(World& world, const RobotSetup& setup, RobotId robot) {
  const Wall own = parked_wall(setup);
  check_wall(world, own, robot, {});
  check_start(world, setup, robot);
  std::vector<Wall> parked = world.statics.parked;
  parked.push_back(own);
  StaticWorld statics = beside(world, std::move(parked), layers_of(world.fleet));
  FloorRoutes planned = routes_among(world, statics);
  planned.travels.reserve(world.fleet.size() + 1);
  if (statics.floors.size() > 1) planned.floor.push_back(0);
  world.claims.resize(std::max(world.claims.size(), statics.floors.size()));
  join(world, setup, robot);
  planned.travels.emplace_back();  // there is room
  world.statics = std::move(statics);
  adopt(world, std::move(planned));
}

void take_away_parked(World& world, std::size_t slot) {
  replace(world, beside(world, world.fleet.parked_walls(slot), layers_of(world.fleet)));
}

void park_or_free(World& world, std::size_t slot, RobotSetup changed) {
  Fleet& fleet = world.fleet;
  changed.goal = changed.position;
  const std::optional<Wall> wall = wall_of(fleet, slot, changed);
  check(world, slot, changed, wall);
  const double sensing_radius = sensing_radius_with(world, changed);
  const std::uint32_t pace = world.pace_of(changed, true);
  std::vector<LayerSet> layers = layers_of(fleet);
  if (!is_parked(changed)) layers.push_back(changed.layers);
  StaticWorld statics = beside(world, fleet.parked_walls(slot, wall), layers);
  FloorRoutes planned = routes_with(world, statics, slot, changed);
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
  adopt(world, std::move(planned));
}

}  // namespace avo::inline sim
