// SPDX-License-Identifier: Apache-2.0
#include "sim/sensing/sensed_neighbors.h"

#include <algorithm>
#include <limits>

#include "core/plane.h"
#include "sim/sensing/senses.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

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

}  // namespace

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

namespace {

// The robot at a place of the snapshot.
std::optional<Neighbor> sensed_at(const World& world, std::size_t place, std::size_t own) {
  const Snapshot& snapshot = world.snapshot;
  auto neighbor = sensed_by(world, own, snapshot.grid.order()[place], snapshot.grid.position(place),
                            snapshot.sensed[place].velocity);
  if (neighbor && !snapshot.circle.empty() && snapshot.circle[place].radius > 0.0)
    neighbor->loiter = snapshot.circle[place];
  return neighbor;
}

// Notes the source of the neighbor just appended, see Worker::sources.
void note(int source, Worker& worker) {
  if (worker.sources != nullptr) worker.sources->push_back(source);
}

}  // namespace

void append_plain(const World& world, std::size_t slot, const Found& hits,
                  const SearchScratch& search, NeighborColumns& to) {
  append(world.snapshot, hits, search, to);
  part_coinciding(world, slot, hits, search, to);
  if (world.summary.exceeds) append_deviations(world, hits, search, to);
  if (!world.outliers.robots.empty()) append_braking(hits, to);
}

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

}  // namespace avo::inline sim
