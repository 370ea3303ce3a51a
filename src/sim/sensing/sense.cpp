// SPDX-License-Identifier: Apache-2.0
// Finds the neighbors that the robots of a tile sense, from the snapshot.
#include "sim/sensing/sense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/plane.h"
#include "sim/sensing/sense_query.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Returns whether all neighbors that are sensed exactly are valid, for any motion since they were
// checked, and so is the place that the robot believes to be at.
bool is_trusted(const World& world, std::size_t slot) {
  const Vec2 p = world.fleet.position[slot];
  return world.summary.is_valid && !world.summary.is_fast &&
         !(world.settings.sensing.localization.position > 0.0) &&
         std::abs(p.x) <= kFarthestTrusted && std::abs(p.y) <= kFarthestTrusted;
}

// Appends in canonical order.
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

// Sets the parting direction of the neighbors just appended that coincide with the robot: only
// their ids distinguish them.
void part_coinciding(const World& world, std::size_t slot, const Found& hits,
                     const SearchScratch& search, NeighborColumns& to) {
  const Vec2 position = world.fleet.position[slot], velocity = world.fleet.velocity[slot];
  const std::size_t before = to.count - hits.count;
  for (std::size_t k = 0; k < hits.count; ++k) {
    const std::size_t place = before + k;
    if (Vec2{to.x[place], to.y[place]} != position) return;  // and neither does any later neighbor
    const std::uint32_t other = world.snapshot.grid.order()[search.order[hits.first + k]];
    if (Vec2{to.v_x[place], to.v_y[place]} == velocity)
      to.part(place, parting_direction(world.fleet.id[slot].value, world.fleet.id[other].value));
  }
}

// Sets the deviations of the neighbors just appended, where some accelerate by more than others
// expect.
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

// Sets their limits of braking, where some have another one.
void append_braking(const Found& hits, NeighborColumns& to) {
  const auto before = static_cast<std::ptrdiff_t>(to.count - hits.count);
  std::copy_n(to.max_acceleration.begin() + before, hits.count, to.max_braking.begin() + before);
}

// The robot in slot B as the one in slot A senses it there; none where A does not avoid it.
std::optional<Neighbor> sensed_by(const World& world, std::size_t a, std::size_t b, Vec2 position,
                                  Vec2 velocity) {
  const Fleet& fleet = world.fleet;
  const auto expected = fleet.expected(b, a);
  if (!expected) return std::nullopt;
  Neighbor neighbor = sensed(fleet.traits[b], fleet.conduct[b], *expected, position, velocity);
  if (fleet.has_footprints && fleet.own_model(b) != nullptr)
    cover(*fleet.own_model(b), world.snapshot.pose[b], neighbor);
  if (position == fleet.position[a] && velocity == fleet.velocity[a])
    neighbor.parting = parting_direction(fleet.id[a].value, fleet.id[b].value);
  return neighbor;
}

// The robot at a place of the snapshot.
std::optional<Neighbor> sensed_at(const World& world, std::size_t place, std::size_t own) {
  const Snapshot& snapshot = world.snapshot;
  auto neighbor = sensed_by(world, own, snapshot.grid.order()[place], snapshot.grid.position(place),
                            snapshot.sensed[place].velocity);
  if (neighbor && !snapshot.circle.empty() && snapshot.circle[place].radius > 0.0)
    neighbor->loiter = snapshot.circle[place];
  return neighbor;
}

// Notes who the neighbor just appended is, see Worker::sources.
void note(int source, Worker& worker) {
  if (worker.sources != nullptr) worker.sources->push_back(source);
}

// Appends the neighbors one by one: among moving obstacles, robots first where distances are equal,
// and where robots are not all alike.
void append_one_by_one(const World& world, std::size_t slot, std::span<const NeighborHit> robots,
                       Worker& worker) {
  NeighborColumns& to = worker.tile.neighbors;
  const std::size_t most =
      world.all_matter_to(slot) ? std::numeric_limits<std::size_t>::max() : world.most_nearest();
  const std::span<const NeighborHit> movers =
      world.mover_grid.gather(world.fleet.position[slot], -1, most, worker.movers);
  const std::size_t first = to.count;
  to.reserve(first + std::min(robots.size() + movers.size(), most));
  auto robot = robots.begin(), mover = movers.begin();
  while (to.count - first < most && (robot != robots.end() || mover != movers.end())) {
    if (mover == movers.end() ||
        (robot != robots.end() && robot->distance_squared <= mover->distance_squared)) {
      const NeighborHit& hit = *robot++;
      const auto neighbor = sensed_at(world, hit.place, slot);
      if (!neighbor) continue;
      to.add(*neighbor);
      note(hit.index, worker);
    } else {
      const int index = (mover++)->index;
      to.add(world.movers.sensed(static_cast<std::size_t>(index)));
      note(-1 - index, worker);
    }
  }
}

// Appends them as they are sensed, where senses are not exact. Returns whether all of them are
// sensed as they truly are.
bool append_sighted(const World& world, std::size_t slot, std::size_t query, Worker& worker) {
  const Snapshot& snapshot = world.snapshot;
  const bool is_exact = world.fleet.bases.are_exact();
  const auto present_at = [&](std::size_t place, int rank) {
    const std::size_t other = snapshot.grid.order()[place];
    const PastState state{snapshot.grid.position(place), snapshot.sensed[place].velocity};
    return Present{other, static_cast<std::size_t>(rank),
                   is_exact ? state : body_of(world.fleet, other)};
  };
  const Found& hits = worker.search.results[query];
  worker.seen.clear();
  for (std::size_t k = hits.first; k < hits.first + hits.count; ++k) {
    const std::size_t place = worker.search.order[k];
    worker.seen.push_back(present_at(place, snapshot.grid.index(place)));
  }
  const Present own{slot,
                    static_cast<std::size_t>(world.fleet.rank[slot]),
                    {world.fleet.position[slot], world.fleet.velocity[slot]}};
  NeighborColumns& to = worker.tile.neighbors;
  const bool may_be_usual = is_exact && world.movers.setup.empty() && worker.sources == nullptr;
  if (may_be_usual && append_as_they_are(world, own, worker.seen, to)) return true;
  std::span<const NeighborHit> movers;
  if (!world.movers.setup.empty()) {
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    movers = world.mover_grid.gather(world.fleet.position[slot], -1, kAll, worker.movers);
  }
  look(world, own, worker.seen, movers, worker.sightings);
  to.reserve(to.count + worker.sightings.size());
  for (const Sighting& sighting : worker.sightings) {
    append(world, sighting, to);
    note(sighting.source, worker);
  }
  return false;
}

// m, a radius that contains the nearest, or all if those are fewer.
float reach_of_nearest(Vec2 position, const Found& hits, std::size_t nearest,
                       const Snapshot& snapshot, const SearchScratch& search) {
  if (hits.candidates < nearest) return std::numeric_limits<float>::infinity();
  if (nearest == 0) return 0.0F;
  const std::uint32_t farthest = search.order[hits.first + nearest - 1];
  return static_cast<float>(norm(snapshot.grid.position(farthest) - position));
}

// Returns whether a search has found that robot: it finds the first ones in canonical order.
bool has_found(const World& world, const Found& hits, const SearchScratch& search, Vec2 position,
               const NeighborHit& outlier, int rank) {
  if (hits.count == 0) return false;
  const std::uint32_t last = search.order[hits.first + hits.count - 1];
  const double farthest = norm_squared(world.snapshot.grid.position(last) - position);
  return !(NeighborHit{farthest, world.snapshot.grid.index(last)} <
           NeighborHit{outlier.distance_squared, rank});
}

// How robot A examines others, if it may sense an outlier or a moving obstacle. Those outliers are
// left in the scratch memory.
Scrutiny look_at_outliers(const World& world, std::size_t a, std::size_t query, Worker& worker) {
  const Fleet& fleet = world.fleet;
  const Outliers& outliers = world.outliers;
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  if (!world.mover_grid.gather(fleet.position[a], -1, 1, worker.movers).empty())
    return Scrutiny::everyone;
  if (outliers.robots.empty()) return outliers.usual;
  Scrutiny scrutiny = outliers.usual;
  for (const NeighborHit& hit :
       outliers.grid.gather(fleet.position[a], -1, kAll, worker.outliers)) {
    const Outlier& outlier = outliers.robots[static_cast<std::size_t>(hit.index)];
    if (outlier.rank == fleet.rank[a] && outlier.stands_apart) return Scrutiny::everyone;
    if (outlier.rank == fleet.rank[a] || !(outlier.is_unlike || outlier.stands_apart)) continue;
    const bool is_found = has_found(world, worker.search.results[query], worker.search,
                                    fleet.position[a], hit, outlier.rank);
    const std::uint32_t b = fleet.slot_of[static_cast<std::size_t>(outlier.rank)];
    const auto expected = fleet.expected(b, a);
    const bool decides = expected == Expectation::decides && fleet.flight(b) == nullptr;
    if (expected ? !decides : is_found) return Scrutiny::everyone;
    if (is_found) scrutiny = std::max(scrutiny, Scrutiny::one_by_one);
  }
  return scrutiny;
}

// All sensed robots: found anew where the search has not looked for all.
std::span<const NeighborHit> find_everyone(const World& world, std::size_t query, Worker& worker) {
  if (world.outliers.usual == Scrutiny::everyone)
    return world.snapshot.grid.list(query, worker.search);
  NeighborQuery all = worker.queries[query];
  all.near = all.far, all.guess = all.far;
  world.snapshot.grid.find({&all, 1}, 1, worker.again);
  return world.snapshot.grid.list(0, worker.again);
}

// How a robot has examined others, and whether it senses robots alone, and these as they truly are.
struct Examined {
  Scrutiny scrutiny;
  bool at_robots;
};

// Appends the neighbors that the robot senses, except those of far reach.
Examined append_sensed(const World& world, std::size_t slot, std::size_t query, Worker& worker) {
  if (!world.senses.are_exact())
    return {Scrutiny::everyone, append_sighted(world, slot, query, worker)};
  Scrutiny scrutiny = world.outliers.usual;
  worker.outliers.hits.clear();
  if (scrutiny != Scrutiny::everyone && world.outliers.may_be_sensed(world.fleet.cell[slot]))
    scrutiny = look_at_outliers(world, slot, query, worker);
  const Found& hits = worker.search.results[query];
  NeighborColumns& to = worker.tile.neighbors;
  if (scrutiny == Scrutiny::plain) {
    append(world.snapshot, hits, worker.search, to);
    part_coinciding(world, slot, hits, worker.search, to);
    if (world.summary.exceeds) append_deviations(world, hits, worker.search, to);
    if (!world.outliers.robots.empty()) append_braking(hits, to);
  } else if (scrutiny == Scrutiny::one_by_one) {
    append_one_by_one(world, slot, world.snapshot.grid.list(query, worker.search), worker);
  } else {
    append_one_by_one(world, slot, find_everyone(world, query, worker), worker);
  }
  return {scrutiny, scrutiny != Scrutiny::everyone};
}

// Appends the neighbors that matter within a longer range than others, where the search has not
// found them anyway. Returns whether there are any.
bool append_far(const World& world, std::size_t slot, std::size_t query, Worker& worker) {
  const Outliers& outliers = world.outliers;
  const Fleet& fleet = world.fleet;
  NeighborColumns& to = worker.tile.neighbors;
  if (!world.all_matter_to(slot)) return false;
  bool some_are_far = false;
  for (const NeighborHit& hit : worker.outliers.hits) {
    const auto k = static_cast<std::size_t>(hit.index);
    const Outlier& outlier = outliers.robots[k];
    if (!outlier.reaches_far || outlier.rank == fleet.rank[slot] ||
        hit.distance_squared > outliers.reach * outliers.reach)
      continue;
    some_are_far = true;
    if (has_found(world, worker.search.results[query], worker.search, fleet.position[slot], hit,
                  outlier.rank))
      continue;
    const auto neighbor =
        sensed_by(world, slot, fleet.slot_of[static_cast<std::size_t>(outlier.rank)],
                  outliers.position[k], outliers.velocity[k]);
    if (!neighbor) continue;
    to.reserve(to.count + 1);
    to.add(*neighbor);
  }
  return some_are_far;
}

}  // namespace

void sense_everyone(const World& world, std::uint32_t slot, Worker& worker) {
  const double radius = world.sensing_radius;
  const NeighborQuery everyone{.position = world.fleet.position[slot],
                               .self = world.fleet.rank[slot],
                               .most = std::numeric_limits<std::size_t>::max(),
                               .near = radius,
                               .far = radius,
                               .guess = radius};
  world.snapshot.grid.find({&everyone, 1}, 1, worker.search);
  if (world.senses.are_exact())
    append_one_by_one(world, slot, world.snapshot.grid.list(0, worker.search), worker);
  else
    append_sighted(world, slot, 0, worker);
  const NeighborColumns& neighbors = worker.tile.neighbors;
  worker.tile.robots.neighbors.push_back({&neighbors, 0, neighbors.count});
}

std::size_t sense(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  Fleet& fleet = world.fleet;
  const Snapshot& snapshot = world.snapshot;
  worker.queries.clear();
  for (const std::uint32_t slot : slots) worker.queries.push_back(sought_by(world, slot));
  const std::size_t robots = snapshot.grid.find(worker.queries, kTileCandidates, worker.search);
  NeighborColumns& neighbors = worker.tile.neighbors;
  for (std::size_t i = 0; i < robots; ++i) {
    const std::uint32_t slot = slots[i];
    const std::size_t first = neighbors.count;
    const auto [scrutiny, at_robots] = append_sensed(world, slot, i, worker);
    double range = scrutiny == Scrutiny::everyone ? kInfinity : range_of(worker.queries[i]);
    // these matter beyond the range, at any place in the list
    if (scrutiny != Scrutiny::everyone && append_far(world, slot, i, worker)) range = kInfinity;
    fleet.nearest[slot] = reach_of_nearest(fleet.position[slot], worker.search.results[i],
                                           nearest_sought(world), snapshot, worker.search);
    worker.tile.robots.neighbors.push_back({&neighbors, first, neighbors.count - first, range});
    worker.tile.trusted = worker.tile.trusted && at_robots && is_trusted(world, slot);
    if (neighbors.count >= kTileCandidates) return i + 1;  // of obstacles
  }
  return robots;
}

}  // namespace avo::inline sim
