// SPDX-License-Identifier: Apache-2.0
// What one robot senses now, and where it wants to go, by the functions of a step. No robot moves.
#include <cstdint>
#include <memory>

#include "planner/decision.h"
#include "sim/sensing/sense.h"
#include "sim/simulation_state.h"

namespace avo {
namespace {

// A sighting's source as Perception::source says it: by ids.
std::int64_t named(const World& world, int source) {
  if (source < 0)
    return -1 -
           static_cast<std::int64_t>(world.movers.id[static_cast<std::size_t>(-1 - source)].value);
  const Fleet& fleet = world.fleet;
  return static_cast<std::int64_t>(fleet.id[fleet.slot_of[static_cast<std::size_t>(source)]].value);
}

void list_neighbors(const World& world, const Worker& alone, Simulation::Perception& seen) {
  list(alone.tile.robots.neighbors[0], seen.neighbors);
  for (Neighbor& neighbor : seen.neighbors) {
    if (neighbor.trajectory == nullptr) continue;
    neighbor.trajectory =  // a copy that outlives the step
        seen.trajectories.emplace_back(std::make_shared<Trajectory>(*neighbor.trajectory)).get();
  }
  for (const int source : *alone.sources) seen.source.push_back(named(world, source));
}

// What each of the floor's walls is of, as Perception::wall_source says it.
std::vector<std::int64_t> wall_sources(const World& world, const Floor& floor) {
  std::vector<std::int64_t> sources;
  const StaticWorld& statics = world.statics;
  for (std::size_t k = 0; k < statics.obstacles.size(); ++k) {
    if (!heeds(floor.layers, statics.obstacles[k])) continue;
    const std::size_t own = walls_of(std::span(statics.obstacles).subspan(k, 1)).size();
    sources.insert(sources.end(), own, static_cast<std::int64_t>(statics.id[k].value));
  }
  for (const std::uint32_t slot : world.fleet.slot_of)
    if (world.fleet.is_parked(slot))
      sources.push_back(-1 - static_cast<std::int64_t>(world.fleet.id[slot].value));
  return sources;
}

void list_walls(const World& world, std::uint32_t slot, const Worker& alone,
                Simulation::Perception& seen) {
  const std::span<const Wall> walls = alone.tile.walls_of(0);
  seen.walls.assign(walls.begin(), walls.end());
  if (walls.empty()) return;
  const Floor& floor = world.statics.floors[world.floor_of(slot)];
  const std::vector<std::int64_t> sources = wall_sources(world, floor);
  for (const std::uint32_t wall : floor.grid.numbers_near(world.fleet.position[slot]))
    seen.wall_source.push_back(sources[wall]);
}

// Takes the robot with what it senses as a tile of its own, as a step does. It remembers in copies.
void set_out_alone(const World& world, std::span<const Claims> claims, std::uint32_t slot,
                   Worker& alone, Simulation::Perception& seen) {
  Travel travel;
  if (!world.travels.empty())
    travel = world.travels[static_cast<std::size_t>(world.fleet.rank[slot])];
  std::uint8_t has_stood = 0;
  alone.tile.detour.push_back(&seen.detour);
  alone.travels.push_back(&travel), alone.has_stood.push_back(&has_stood);
  alone.told = &seen.guide;
  set_out(world, world.pace(slot), claims, {&slot, 1}, alone);
  seen.robot = alone.tile.robots.robot(0);
  seen.robot.max_braking = max_braking_of(world.fleet.traits[slot]);
  list_walls(world, slot, alone, seen);
  if (!alone.staying.empty()) seen.stop = stop_of(world, slot);
}

}  // namespace

std::optional<Simulation::Wait> Simulation::wait(RobotId robot) const {
  State& state = *state_;
  state.catch_up();
  const std::span<const Claims> claims = state.claims_now();
  return wait_of(state, claims, state.fleet.find(robot));
}

Simulation::Perception Simulation::perceive(RobotId robot) const {
  State& state = *state_;
  state.look_at_present();
  const auto slot = static_cast<std::uint32_t>(state.fleet.find(robot));
  Worker alone;
  std::vector<int> sources;
  alone.sources = &sources;
  if (state.fleet.is_parked(slot))
    alone.tile.robots.neighbors.push_back({&alone.tile.neighbors, 0, 0});
  else
    sense_everyone(state, slot, alone);
  Perception seen;
  seen.detour = state.fleet.detour[slot];
  list_neighbors(state, alone, seen);
  seen.among_movers = state.fleet.flight(slot) == nullptr &&
                      is_among_movers(state.pace(slot).planner.options(), seen.neighbors);
  seen.wait = wait(robot);
  set_out_alone(state, state.claims_now(), slot, alone, seen);
  return seen;
}

}  // namespace avo
