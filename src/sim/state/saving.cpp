// SPDX-License-Identifier: Apache-2.0
// What of a world is saved.
#include <vector>

#include "sim/state/saved_state.h"
#include "sim/world.h"

namespace avo::inline sim {

SavedState saved_state(const World& world) {
  const Fleet& fleet = world.fleet;
  SavedState state;
  state.scene = world.settings;
  state.bases = world.fleet.bases;
  state.sensing_radius = world.sensing_radius;
  state.steps = world.steps, state.now = world.now;
  state.next_id = world.next_id;
  state.next_obstacle = world.statics.next_id;
  state.static_ids = world.statics.id;
  if (world.senses.remember()) {
    state.since = world.senses.since;
    if (!world.senses.by_time) state.past = world.senses.past;
    for (const Track& track : world.senses.tracks) {
      std::vector<Knot>& knots = state.tracks.emplace_back();
      for (std::size_t k = 0; k < track.count; ++k) knots.push_back(track[k]);
    }
  }
  state.routes.reserve(world.travels.size());
  for (std::size_t rank = 0; rank < world.travels.size(); ++rank) {
    const Travel& travel = world.travels[rank];
    const double radius = fleet.traits[fleet.slot_of[rank]].route_radius;
    state.routes.push_back({travel.target, travel.graph && travel.graph->radius == radius,
                            travel.around_movers, travel.ends, travel.place, travel.waiting});
  }
  state.scene.moving_obstacles = world.movers.setup;
  state.scene.obstacles = world.statics.obstacles;
  state.mover_ids = world.movers.id, state.next_mover = world.movers.next_id;
  for (std::size_t k = 0; k < world.movers.setup.size(); ++k) {
    state.movers.push_back(
        {world.movers.position[k], world.movers.velocity[k], world.movers.next_point[k]});
  }
  state.scene.robots.reserve(fleet.size());
  state.robots.reserve(fleet.size());
  for (const std::uint32_t slot : fleet.slot_of) {
    state.scene.robots.push_back(fleet.setup(slot));
    state.robots.push_back({fleet.id[slot], fleet.position[slot], fleet.velocity[slot],
                            fleet.heading[slot], fleet.detour[slot]});
    if (fleet.has_stood[slot] != 0) state.stood.push_back(fleet.id[slot].value);
    if (const auto told = fleet.told_velocity(slot))
      state.told.push_back({fleet.id[slot].value, *told});
    if (const HostMotion* motion = fleet.moved_by_host(slot))
      state.host_motions.push_back({fleet.id[slot].value, *motion});
    if (const Flight* flight = fleet.flight(slot))
      state.flights.push_back({flight->circle, flight->has_arrived});
    if (!fleet.has_clocks) continue;
    const OwnClock& clock = fleet.clock_of(slot);
    state.clocks.push_back({clock.begin, clock.end, clock.from, clock.to, clock.has_decided});
  }
  return state;
}

}  // namespace avo::inline sim
