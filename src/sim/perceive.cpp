// SPDX-License-Identifier: Apache-2.0
// What one robot senses now, and the robot for which it waits, on demand: a step computes it for
// all.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

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
    if (neighbor.position == position && neighbor.velocity == fleet.velocity[slot])
      neighbor.parting = parting_direction(fleet.id[slot].value, fleet.id[other].value);
    add(neighbor, static_cast<int>(rank), robots);
  }
  for (std::size_t k = 0; k < world.obstacles.setup.size(); ++k)
    add(world.obstacles.sensed(k), -1 - static_cast<int>(k), movers);
}

// The value of the id at that index into fleet().
std::int64_t number_at(const Fleet& fleet, int index) {
  return static_cast<std::int64_t>(fleet.id[fleet.slot_of[static_cast<std::size_t>(index)]].value);
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
  for (const Sighting& seen : sightings)
    result.push_back({neighbor_of(world, seen), seen.distance_squared, seen.source});
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

}  // namespace

std::optional<Simulation::Wait> Simulation::wait(std::size_t robot) const {
  State& state = *state_;
  state.catch_up();
  {
    const Lock lock(state.looking);
    if (state.changed) find_walls(state);
    if (state.ways.passages.empty()) return std::nullopt;
    if (!state.has_claims) collect_claims(state, state.serial, state.present_claims);
    state.has_claims = true;
  }
  return wait_of(state, state.present_claims, state.fleet.slot_of[robot]);
}

Simulation::Perception Simulation::perceive(std::size_t robot) const {
  State& state = *state_;
  state.catch_up();
  if (state.changed || state.has_new_goals || state.obstacles.has_paths) {
    const Lock lock(state.looking);
    if (state.changed) find_walls(state);
    find_shared_goals(state);
    foresee(state);
  }
  const std::uint32_t slot = state.fleet.slot_of[robot];
  const std::vector<Perceived> sensed = all_sensed(state, slot);
  const double nearest = sensed.empty() ? std::numeric_limits<double>::infinity()
                                        : std::sqrt(sensed.front().distance_squared);
  Perception seen;
  seen.detour = state.fleet.detour[slot];
  for (const Perceived& one : sensed) {
    Neighbor& neighbor = seen.neighbors.emplace_back(one.neighbor);
    if (neighbor.trajectory != nullptr)  // a copy that outlives the step
      neighbor.trajectory =
          seen.trajectories.emplace_back(std::make_shared<Trajectory>(*neighbor.trajectory)).get();
    const int source = one.source;
    seen.source.push_back(source < 0 ? source : number_at(state.fleet, source));
  }
  const std::span<const Wall> walls = state.statics.grid.near(state.fleet.position[slot]);
  const Vec2 lost = own_error(state, slot);
  for (const Wall& wall : walls) seen.walls.push_back(lost == Vec2{} ? wall : moved(wall, -lost));
  seen.robot = state.robot(slot, nearest, seen);
  seen.among_movers = !is_airplane(seen.robot.model) &&
                      is_among_movers(state.pace(slot).planner.options(), seen.neighbors);
  seen.wait = wait(robot);
  return seen;
}

}  // namespace avo
