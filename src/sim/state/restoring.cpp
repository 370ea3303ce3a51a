// SPDX-License-Identifier: Apache-2.0
// Restores a world's state.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/ranges.h"
#include "sim/floors.h"
#include "sim/state/same_scene.h"
#include "sim/state/saved_state.h"
#include "sim/travels.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

bool are_same(const std::vector<Wall>& theirs, const std::vector<Wall>& ours) {
  return std::equal(theirs.begin(), theirs.end(), ours.begin(), ours.end(),
                    [](const Wall& a, const Wall& b) {
                      return a.a == b.a && a.b == b.b && a.radius == b.radius;
                    });
}

void add_clocks(const SavedState& state, Fleet& fleet) {
  for (std::size_t k = 0; k < state.clocks.size(); ++k) {
    const SavedClock& saved = state.clocks[k];
    OwnClock& clock = fleet.clock[k];
    clock.time_step = time_step_of(state.scene, state.scene.robots[k]);
    clock.begin = saved.begin, clock.end = saved.end;
    clock.from = saved.from, clock.to = saved.to;
    if (is_holonomic(state.scene.robots[k].model))
      clock.from.heading = clock.to.heading = fleet.heading[k];
    clock.has_decided = saved.has_decided;
  }
}

void take_told(const SavedState& state, Fleet& fleet) {
  if (state.told.empty()) return;
  fleet.told.resize(fleet.size());
  for (const SavedTold& told : state.told)
    fleet.told[static_cast<std::size_t>(fleet.rank[fleet.find({told.robot})])] = told.velocity;
}

void take_host_motions(const SavedState& state, Fleet& fleet) {
  if (state.host_motions.empty()) return;
  fleet.host_motion.resize(fleet.size());
  for (const SavedHostMotion& saved : state.host_motions)
    fleet.host_motion[static_cast<std::size_t>(fleet.rank[fleet.find({saved.robot})])] =
        saved.motion;
}

// Makes the fleet. The paces are the world's.
Fleet fleet_of(const SavedState& state, World& world) {
  Fleet fleet;
  fleet.has_clocks = state.scene.clock == Clock::free;
  fleet.usual = usual_method(state.scene);
  fleet.reserve(state.robots.size());
  for (std::size_t k = 0; k < state.robots.size(); ++k) {
    const SavedRobot& robot = state.robots[k];
    RobotSetup setup = state.scene.robots[k];
    setup.heading = robot.heading;
    fleet.add(robot.id, setup, world.pace_of(setup));
    fleet.position[k] = robot.position;  // of its disc, to the last bit
    fleet.velocity[k] = robot.velocity;  // to the last bit, also along a heading
    fleet.detour[k] = robot.detour;
    fleet.has_stood[k] =
        std::binary_search(state.stood.begin(), state.stood.end(), robot.id.value) ? 1 : 0;
  }
  std::size_t flights = 0;
  for (std::size_t k = 0; k < state.robots.size(); ++k) {
    Flight* flight = fleet.flight(k);
    if (flight == nullptr) continue;
    const SavedFlight& saved = state.flights[flights++];
    *flight = {saved.circle, saved.has_arrived};
  }
  return fleet;
}

MoverColumns movers_of(const SavedState& state) {
  MoverColumns movers(state.scene.moving_obstacles);
  movers.id = state.mover_ids, movers.next_id = state.next_mover;
  for (std::size_t k = 0; k < state.movers.size(); ++k) {
    movers.position[k] = state.movers[k].position;
    movers.velocity[k] = state.movers[k].velocity;
    movers.next_point[k] = state.movers[k].next_point;
  }
  movers.steps = state.steps;
  return movers;
}

// Its steps so far, in a track with room for more.
Track track_of(const SavedState& state, std::size_t k, double longest_step) {
  Track track;
  track.ring.resize(knots_needed(state.scene, longest_step, state.scene.robots[k]));
  for (const Knot& knot : state.tracks[k]) track.add(knot);
  return track;
}

Senses senses_of(const SavedState& state, const Fleet& fleet, double longest_step) {
  Senses senses = senses_of(state.scene);
  if (senses.by_time) {
    senses.since = state.since;
    senses.past.resize(fleet.size() * senses.depth);
    for (std::size_t k = 0; k < fleet.size(); ++k)
      senses.tracks.push_back(track_of(state, k, longest_step));
    senses.note(fleet, state.steps);
    return senses;
  }
  if (senses.remember()) {
    senses.since = state.since;
    senses.past = state.past;
    return senses;
  }
  for (std::size_t k = 0; k < fleet.size(); ++k) senses.add(state.steps);
  senses.note(fleet, state.steps);
  return senses;
}

// Restores the time that it has waited, and the gaps that it goes around.
void keep_waiting(const SavedRoute& route, Vec2 position, double radius, LegScratch& scratch,
                  Travel& travel) {
  if (!route.waiting.closed.empty() && travel.graph != nullptr) {
    travel = around(travel, position, radius, route.waiting.closed, scratch);
    aim_at(travel, route.target, scratch);
  }
  travel.waiting.least = route.waiting.least, travel.waiting.waited = route.waiting.waited;
  travel.waiting.looks_at = route.waiting.looks_at;
  travel.waiting.opens_at = route.waiting.opens_at;
}

// Makes the routes with the saved targets: no robot searches for its route again.
std::vector<Travel> travels_of(const SavedState& state, const StaticWorld& statics,
                               std::span<Routes> routes, std::span<const std::uint32_t> floor) {
  const std::size_t count = has_routes(statics, routes) ? state.robots.size() : 0;
  if (state.routes.size() != count)
    refuse("saved state", std::to_string(state.routes.size()) + " routes", std::to_string(count));
  std::vector<Travel> travels;
  travels.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const RobotSetup& setup = state.scene.robots[k];
    if (is_parked(setup)) {
      travels.emplace_back();
      continue;
    }
    const SavedRoute& route = state.routes[k];
    const Vec2 end = route.ends == RouteEnd::goal ? setup.goal : route.place;
    Routes& own = routes[floor.empty() ? 0 : floor[k]];
    const double radius = route_radius(setup.model, disc_radius(setup));
    Travel travel = own.resume(radius, end, route.target, route.is_exact,
                               route.around_movers && own.goes_around_movers());
    travel.ends = route.ends, travel.place = route.place;
    keep_waiting(route, state.robots[k].position, radius, own.scratch(), travel);
    travels.push_back(std::move(travel));
  }
  return travels;
}

// Returns whether the static world has a floor for each robot.
bool has_floors(const StaticWorld& statics, const Fleet& fleet) {
  const std::vector<LayerSet> layers = layers_of(fleet);
  return std::all_of(layers.begin(), layers.end(),
                     [&](LayerSet robot) { return statics.floor_of(robot).has_value(); });
}

void take_numbers(const SavedState& state, World& world) {
  world.statics.next_id = state.next_obstacle;
  world.sensing_radius = state.sensing_radius;
  world.steps = state.steps;
  world.now = state.now;
  world.next_id = state.next_id;
}

// Forgets what belongs to the steps before, of which one may be torn.
void forget_step(World& world) {
  world.before = -1;
  world.next_layout = world.steps + 1;
  world.changed = world.has_new_goals = world.is_current = true;
  world.torn = false;
  for (Worker& worker : world.workers) {
    worker.tile.clear();
    worker.staying.clear();
    worker.fast = false;
  }
}

}  // namespace

void restore(const SavedState& state, World& world) {
  require_same_scene(state, world);
  Fleet fleet = fleet_of(state, world);
  take_told(state, fleet);
  take_host_motions(state, fleet);
  fleet.bases = state.bases;
  add_clocks(state, fleet);
  Senses senses = senses_of(state, fleet, world.planner().options().longest_step);
  MoverColumns movers = movers_of(state);
  std::optional<StaticWorld> statics;
  std::vector<Routes> other_routes;
  std::vector<Wall> parked = fleet.parked_walls();
  if (state.static_ids != world.statics.id || state.scene.obstacles != world.statics.obstacles ||
      !are_same(parked, world.statics.parked) || !has_floors(world.statics, fleet))
    statics.emplace(state.scene.obstacles, state.static_ids, state.next_obstacle, std::move(parked),
                    layers_of(fleet));
  const StaticWorld& known = statics ? *statics : world.statics;
  std::vector<std::uint32_t> floor = floors_of(fleet, known);
  std::vector<Claims> claims(known.floors.size());
  std::vector<Wall> resting = movers.resting();
  if (statics || !are_same(resting, world.routes.front().resting())) {
    for (const Floor& own : known.floors)
      other_routes.emplace_back(route_rules_of(world.settings), own.walls, resting,
                                &world.routes[world.statics.floor_of(own.layers).value_or(0)]);
  }
  std::vector<Routes>& routes = other_routes.empty() ? world.routes : other_routes;
  std::vector<Travel> travels = travels_of(state, known, routes, floor);
  for (Routes& own : other_routes) own.forget_before();
  std::vector<Pace> paces = paces_among(world, !movers.setup.empty());
  std::vector<Team> teams = state.scene.teams;
  // nothing throws from here on
  std::swap(world.paces, paces);
  std::swap(world.fleet, fleet);
  world.kinds.reset();
  forget(world.bystanders);
  std::swap(world.senses, senses);
  std::swap(world.movers, movers);
  std::swap(world.travels, travels), std::swap(world.floor, floor);
  std::swap(world.claims, claims);
  std::swap(world.settings.teams, teams);
  if (statics) std::swap(world.statics, *statics);
  if (!other_routes.empty()) std::swap(world.routes, other_routes);
  take_numbers(state, world);
  forget_step(world);
}

}  // namespace avo::inline sim
