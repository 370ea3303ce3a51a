// SPDX-License-Identifier: Apache-2.0
// Whom the robots of a tile sense, from the snapshot.
#include "sim/sense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/world.h"

namespace avo {
namespace {

// Whether whomever it senses is valid, however all have moved since they were looked at.
bool is_trusted(const World& world, std::size_t slot) {
  const Vec2 p = world.fleet.position[slot];
  return world.valid && !world.fast && world.senses.are_exact() &&
         std::abs(p.x) <= kFarthestTrusted && std::abs(p.y) <= kFarthestTrusted;
}

// m: others farther away matter only if they are among the nearest.
double near_range(const World& world, std::size_t slot) {
  if (!world.senses.are_exact()) return world.sensing_radius;
  if (!world.all_matter() && !world.selective) return -1.0;
  const Vec2 p = world.fleet.position[slot];
  const double everyone = world.sensing_radius;
  const double farthest = std::max({std::abs(p.x), std::abs(p.y), everyone});
  // among movers it matters whether anybody decides at all
  if (world.fast || world.selective || !world.obstacles.setup.empty() ||
      !(farthest <= kMostRelevantPosition))
    return everyone;
  return world.fleet.range[slot].at(norm(world.fleet.velocity[slot]));
}

// Of all, those are chosen later whom it minds.
std::size_t nearest_sought(const World& world) {
  return world.selective ? std::numeric_limits<std::size_t>::max() : world.most_nearest();
}

NeighborQuery query_of(const World& world, std::size_t slot) {
  constexpr double kMargin = 1.125;  // for having moved since
  const Fleet& fleet = world.fleet;
  return {.position = fleet.position[slot],
          .self = fleet.rank[slot],
          .most = nearest_sought(world),
          .near = near_range(world, slot),
          .far = world.sensing_radius,
          .guess = kMargin * static_cast<double>(fleet.nearest[slot])};
}

// m, see Neighbors.
double range_of(const NeighborQuery& query) {
  const bool is_less = query.near >= 0.0 && query.near < query.far;
  return is_less ? query.near : std::numeric_limits<double>::infinity();
}

// In canonical order, behind the others.
void append(const Snapshot& snapshot, const Found& hits, const SearchScratch& search,
            NeighborColumns& to) {
  to.reserve(to.count + hits.count);
  for (std::size_t k = hits.first; k < hits.first + hits.count; ++k, ++to.count) {
    const std::uint32_t place = search.order[k];
    const Vec2 p = snapshot.grid.position(place);
    const Sensed& sensed = snapshot.sensed[place];
    to.x[to.count] = p.x, to.y[to.count] = p.y;
    to.v_x[to.count] = sensed.velocity.x, to.v_y[to.count] = sensed.velocity.y;
    to.radius[to.count] = sensed.radius;
    to.max_acceleration[to.count] = sensed.max_acceleration;
  }
}

// Those just appended who coincide with the one that looks: nothing but their ids tells them apart.
void part_coinciding(const World& world, std::size_t slot, const Found& hits,
                     const SearchScratch& search, NeighborColumns& to) {
  const Vec2 position = world.fleet.position[slot], velocity = world.fleet.velocity[slot];
  const std::size_t before = to.count - hits.count;
  for (std::size_t k = 0; k < hits.count; ++k) {
    const std::size_t place = before + k;
    if (Vec2{to.x[place], to.y[place]} != position) return;  // nor anybody behind it
    const std::uint32_t other = world.snapshot.grid.order()[search.order[hits.first + k]];
    if (Vec2{to.v_x[place], to.v_y[place]} == velocity)
      to.part(place, parting_direction(world.fleet.id[slot].value, world.fleet.id[other].value));
  }
}

// What those just appended are told of besides, where some accelerate by more than others expect.
void append_deviations(const World& world, const Found& hits, const SearchScratch& search,
                       NeighborColumns& to) {
  to.has_deviations = true;
  const std::size_t before = to.count - hits.count;
  for (std::size_t k = 0; k < hits.count; ++k) {
    const RobotTraits& other =
        world.fleet.traits[world.snapshot.grid.order()[search.order[hits.first + k]]];
    to.motion[before + k].max_deviation = other.exceeds ? top_acceleration(other) : 0.0;
  }
}

// The robot at a place of the snapshot; nothing where the one that looks does not mind it.
std::optional<Neighbor> sensed_at(const World& world, std::size_t place, std::size_t own) {
  const std::uint32_t slot = world.snapshot.grid.order()[place];
  const Conduct& conduct = world.fleet.conduct[slot];
  const auto expected = expected_of(conduct, world.fleet.conduct[own]);
  if (conduct.parked || !expected) return std::nullopt;
  Neighbor neighbor =
      sensed(world.fleet.traits[slot], conduct, *expected, world.snapshot.grid.position(place),
             world.snapshot.sensed[place].velocity);
  if (!world.snapshot.circle.empty() && world.snapshot.circle[place].radius > 0.0)
    neighbor.loiter = world.snapshot.circle[place];
  if (neighbor.position == world.fleet.position[own] &&
      neighbor.velocity == world.fleet.velocity[own])
    neighbor.parting = parting_direction(world.fleet.id[own].value, world.fleet.id[slot].value);
  return neighbor;
}

// The same among moving obstacles, robots first where distances are equal, and where robots are not
// all alike.
void append_one_by_one(const World& world, std::size_t slot, std::size_t query, Worker& worker) {
  const Vec2 position = world.fleet.position[slot];
  NeighborColumns& to = worker.tile.neighbors;
  const std::size_t most =
      world.all_matter_to(slot) ? std::numeric_limits<std::size_t>::max() : world.most_nearest();
  const std::span<const NeighborHit> robots = world.snapshot.grid.list(query, worker.search);
  const std::span<const NeighborHit> obstacles =
      world.obstacle_grid.gather(position, -1, most, worker.obstacles);
  const std::size_t first = to.count;
  to.reserve(first + std::min(robots.size() + obstacles.size(), most));
  auto robot = robots.begin(), obstacle = obstacles.begin();
  while (to.count - first < most && (robot != robots.end() || obstacle != obstacles.end())) {
    if (obstacle == obstacles.end() ||
        (robot != robots.end() && robot->distance_squared <= obstacle->distance_squared)) {
      if (const auto neighbor = sensed_at(world, (robot++)->place, slot)) to.add(*neighbor);
    } else {
      to.add(world.obstacles.sensed(static_cast<std::size_t>((obstacle++)->index)));
    }
  }
}

// The same as they are sensed, where senses are not exact.
void append_sighted(const World& world, std::size_t slot, std::size_t query, Worker& worker) {
  NeighborColumns& to = worker.tile.neighbors;
  const std::span<const NeighborHit> robots = world.snapshot.grid.list(query, worker.search);
  std::span<const NeighborHit> movers;
  if (!world.obstacles.setup.empty()) {
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    movers = world.obstacle_grid.gather(world.fleet.position[slot], -1, kAll, worker.obstacles);
  }
  look(world, slot, robots, movers, worker.sightings);
  to.reserve(to.count + worker.sightings.size());
  for (const Sighting& sighting : worker.sightings) to.add(sighting.neighbor);
}

// m, within which are the nearest, or all if those are fewer.
float reach_of_nearest(Vec2 position, const Found& hits, std::size_t nearest,
                       const Snapshot& snapshot, const SearchScratch& search) {
  if (hits.candidates < nearest) return std::numeric_limits<float>::infinity();
  if (nearest == 0) return 0.0F;
  const std::uint32_t farthest = search.order[hits.first + nearest - 1];
  return static_cast<float>(norm(snapshot.grid.position(farthest) - position));
}

}  // namespace

NeighborQuery sought_by(const World& world, std::size_t slot) {
  return query_of(world, slot);
}

std::size_t sense(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  Fleet& fleet = world.fleet;
  const Snapshot& snapshot = world.snapshot;
  worker.queries.clear();
  for (const std::uint32_t slot : slots) worker.queries.push_back(query_of(world, slot));
  const std::size_t robots = snapshot.grid.find(worker.queries, kTileCandidates, worker.search);
  for (std::size_t i = 0; i < robots; ++i) {
    const std::size_t first = worker.tile.neighbors.count;
    if (!world.senses.are_exact()) {
      append_sighted(world, slots[i], i, worker);
    } else if (world.alike && world.obstacles.setup.empty()) {
      append(snapshot, worker.search.results[i], worker.search, worker.tile.neighbors);
      part_coinciding(world, slots[i], worker.search.results[i], worker.search,
                      worker.tile.neighbors);
      if (world.exceeding)
        append_deviations(world, worker.search.results[i], worker.search, worker.tile.neighbors);
    } else {
      append_one_by_one(world, slots[i], i, worker);
    }
    fleet.nearest[slots[i]] = reach_of_nearest(fleet.position[slots[i]], worker.search.results[i],
                                               nearest_sought(world), snapshot, worker.search);
    const NeighborColumns& neighbors = worker.tile.neighbors;
    worker.tile.robots.neighbors.push_back(
        {&neighbors, first, neighbors.count - first, range_of(worker.queries[i])});
    worker.tile.trusted = worker.tile.trusted && is_trusted(world, slots[i]);
    if (worker.tile.neighbors.count >= kTileCandidates) return i + 1;  // of obstacles
  }
  return robots;
}

}  // namespace avo
