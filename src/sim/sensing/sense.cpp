// SPDX-License-Identifier: Apache-2.0
// Finds the neighbors that the robots of a tile sense, from the snapshot.
#include "sim/sensing/sense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/plane.h"
#include "sim/sensing/sense_query.h"
#include "sim/sensing/sensed_neighbors.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Returns whether all neighbors that are sensed exactly are valid, for any motion since they were
// checked. The place where the robot believes to be has to be valid as well.
bool is_trusted(const World& world, std::size_t slot) {
  const Vec2 p = world.fleet.position[slot];
  return world.summary.is_valid && !world.summary.is_fast &&
         !(world.settings.sensing.localization.position > 0.0) &&
         std::abs(p.x) <= kFarthestTrusted && std::abs(p.y) <= kFarthestTrusted;
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
    append_plain(world, slot, hits, worker.search, to);
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
