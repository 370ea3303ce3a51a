// SPDX-License-Identifier: Apache-2.0
// What one robot senses now, and the robot for which it waits, on demand: a step computes it for
// all.
#include <algorithm>
#include <memory>

#include "certificate/discs.h"
#include "core/mutex.h"
#include "planner/decision.h"
#include "sim/simulation_state.h"

namespace avo {
namespace {

struct Perceived {
  Neighbor neighbor;
  double distance_squared = 0.0;  // m², to its sensed place
  int source = 0;                 // see Sighting
};

// Gives a robot its footprint, in the pose that it has now.
void cover_now(const World& world, std::size_t slot, Neighbor& neighbor) {
  const Fleet& fleet = world.fleet;
  if (!fleet.has_footprints || fleet.own_model(slot) == nullptr) return;
  const StepLaw law = certificate_law(world.certified_planner()).step;
  const MotionModel& model = *fleet.own_model(slot);
  cover(model,
        braking_pose(model, fleet.velocity[slot], fleet.heading[slot],
                     fleet.traits[slot].max_braking, law),
        neighbor);
}

// Appends all robots and movers within the sensing radius of a robot, in their true states, by
// testing all.
void append_all(const World& world, std::size_t slot, std::vector<Perceived>& robots,
                std::vector<Perceived>& movers) {
  const Fleet& fleet = world.fleet;
  if (fleet.conduct[slot].parked) return;
  const Vec2 position = fleet.position[slot];
  const double radius = world.sensing_radius;
  const auto add = [&](const Neighbor& neighbor, int source, std::vector<Perceived>& to) {
    const double distance_squared = norm_squared(neighbor.position - position);
    if (!is_finite(neighbor.position) || !is_finite(position)) return;
    if (distance_squared <= radius * radius) to.push_back({neighbor, distance_squared, source});
  };
  for (std::size_t rank = 0; rank < fleet.size(); ++rank) {
    const std::uint32_t other = fleet.slot_of[rank];
    const auto expected = fleet.expected(other, slot);
    if (other == slot || !expected) continue;
    Neighbor neighbor = fleet.sensed(other, *expected);
    cover_now(world, other, neighbor);
    if (neighbor.position == position && neighbor.velocity == fleet.velocity[slot])
      neighbor.parting = parting_direction(fleet.id[slot].value, fleet.id[other].value);
    add(neighbor, static_cast<int>(rank), robots);
  }
  for (std::size_t k = 0; k < world.obstacles.setup.size(); ++k)
    add(world.obstacles.sensed(k), -1 - static_cast<int>(k), movers);
}

// A sighting's source as Perception::source says it: by ids.
std::int64_t named(const World& world, int source) {
  if (source < 0)
    return -1 - static_cast<std::int64_t>(
                    world.obstacles.id[static_cast<std::size_t>(-1 - source)].value);
  const Fleet& fleet = world.fleet;
  return static_cast<std::int64_t>(fleet.id[fleet.slot_of[static_cast<std::size_t>(source)]].value);
}

// The same as the robot senses them, where senses are not exact.
std::vector<Perceived> as_sensed(const World& world, std::size_t slot,
                                 const std::vector<Perceived>& robots,
                                 const std::vector<Perceived>& movers) {
  const Fleet& fleet = world.fleet;
  const auto present = [&](std::size_t rank) {
    const std::size_t other = fleet.slot_of[rank];
    return Present{other, rank, {fleet.position[other], fleet.velocity[other]}};
  };
  std::vector<Present> others;
  for (const Perceived& robot : robots)
    others.push_back(present(static_cast<std::size_t>(robot.source)));
  std::vector<NeighborHit> hits;
  for (const Perceived& mover : movers)
    hits.push_back({mover.distance_squared, -1 - mover.source, 0});
  std::vector<Sighting> sightings;
  look(world, present(static_cast<std::size_t>(fleet.rank[slot])), others, hits, sightings);
  std::vector<Perceived> result;
  for (const Sighting& seen : sightings) {
    Neighbor neighbor = neighbor_of(world, seen);
    if (seen.source >= 0) cover_now(world, seen.slot, neighbor);
    result.push_back({neighbor, seen.distance_squared, seen.source});
  }
  return result;
}

// The neighbors that it senses, in the order in which it plans with them.
std::vector<Perceived> all_sensed(const World& world, std::size_t slot) {
  std::vector<Perceived> robots, movers;
  append_all(world, slot, robots, movers);
  if (!world.senses.are_exact()) return as_sensed(world, slot, robots, movers);
  robots.insert(robots.end(), movers.begin(), movers.end());
  // robots come before obstacles and ids ascend
  std::stable_sort(robots.begin(), robots.end(), [](const Perceived& a, const Perceived& b) {
    return a.distance_squared < b.distance_squared;
  });
  if (!world.all_matter_to(slot) && robots.size() > world.most_nearest())
    robots.resize(world.most_nearest());
  return robots;
}

// Takes the robot with what it senses as a tile of its own, as a step does.
void set_out_alone(const World& world, std::span<const Claims> claims, std::uint32_t slot,
                   Simulation::Perception& seen) {
  Worker alone;
  Tile& tile = alone.tile;
  tile.neighbors.reserve(seen.neighbors.size());
  for (const Neighbor& neighbor : seen.neighbors) tile.neighbors.add(neighbor);
  tile.robots.neighbors.push_back({&tile.neighbors, 0, seen.neighbors.size()});
  Travel travel;
  if (!world.travels.empty())
    travel = world.travels[static_cast<std::size_t>(world.fleet.rank[slot])];
  std::uint8_t has_stood = 0;
  tile.detour.push_back(&seen.detour);
  alone.travels.push_back(&travel), alone.has_stood.push_back(&has_stood);
  alone.told = &seen.guide;
  set_out(world, world.pace(slot), claims, {&slot, 1}, alone);
  seen.robot = tile.robots.robot(0);
  seen.robot.max_braking = max_braking_of(world.fleet.traits[slot]);
  const std::span<const Wall> walls = tile.walls_of(0);
  seen.walls.assign(walls.begin(), walls.end());
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
  state.catch_up();
  if (state.changed || state.has_new_goals || state.obstacles.has_paths) {
    const Lock lock(state.looking);
    if (state.changed) find_walls(state);
    find_shared_goals(state);
    foresee(state);
  }
  const auto slot = static_cast<std::uint32_t>(state.fleet.find(robot));
  Perception seen;
  seen.detour = state.fleet.detour[slot];
  for (const Perceived& one : all_sensed(state, slot)) {
    Neighbor& neighbor = seen.neighbors.emplace_back(one.neighbor);
    if (neighbor.trajectory != nullptr)  // a copy that outlives the step
      neighbor.trajectory =
          seen.trajectories.emplace_back(std::make_shared<Trajectory>(*neighbor.trajectory)).get();
    seen.source.push_back(named(state, one.source));
  }
  seen.among_movers = state.fleet.flight(slot) == nullptr &&
                      is_among_movers(state.pace(slot).planner.options(), seen.neighbors);
  seen.wait = wait(robot);
  set_out_alone(state, state.claims_now(), slot, seen);
  return seen;
}

}  // namespace avo
