// SPDX-License-Identifier: Apache-2.0
// The sensing-acting cycle of a fleet (paper §IV-D): all robots decide from the same snapshot, each
// alone, and move.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "planner/decision.h"
#include "sim/world.h"

namespace avo {
namespace {

// Steps for which robots that were put in order stay near their neighbors in memory, and the
// smallest fleet that does not stay in the cache as it is.
constexpr std::int64_t kStepsInOrder = 16;
constexpr std::size_t kFewestOrdered = 1024;

// m, m/s: who is nearer to one that is no farther out is within the limits of all numbers.
constexpr double kFarthestTrusted = 1e11;

Executor& executor_of(World& world) {
  if (world.fleet.size() < kFewestParallel) return world.serial;
  return *world.executor;
}

// Whether whomever it senses is valid, however all have moved since they were looked at.
bool is_trusted(const World& world, std::size_t slot) {
  const Vec2 p = world.fleet.position[slot];
  return world.valid && !world.fast && world.senses.are_exact() &&
         std::abs(p.x) <= kFarthestTrusted && std::abs(p.y) <= kFarthestTrusted;
}

// How far each robot has to look, as long as none is fast.
void find_ranges(World& world) {
  Fleet& fleet = world.fleet;
  const auto limits = [&](std::size_t slot) {
    const RobotTraits& robot_traits = fleet.traits[slot];
    Robot robot;
    robot.radius = robot_traits.radius;
    robot.max_acceleration = robot_traits.max_acceleration;
    robot.max_speed = robot_traits.max_speed;
    robot.priority = fleet.conduct[slot].priority;
    return robot;
  };
  Peers peers;
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    if (!fleet.conduct[i].parked) include(peers, world.planner, limits(i));
  }
  double sum = 0.0;
  world.fast = false;
  world.parked = static_cast<std::size_t>(
      std::count_if(fleet.conduct.begin(), fleet.conduct.end(),
                    [](const Conduct& conduct) { return conduct.parked; }));
  const Conduct usual;
  world.layered =
      std::any_of(fleet.conduct.begin(), fleet.conduct.end(), [&](const Conduct& conduct) {
        return !(conduct.layers == usual.layers && conduct.avoids == usual.avoids);
      });
  if (world.layered) fleet.seen_acceleration.resize(fleet.size());
  world.selective = world.parked > 0 || world.layered;
  world.alike = std::all_of(fleet.conduct.begin(), fleet.conduct.end(),
                            [](const Conduct& conduct) { return conduct == Conduct{}; });
  for (const std::uint32_t slot : fleet.slot_of) {
    fleet.range[slot] = relevant_range(world.planner, limits(slot), peers);
    sum += std::min(fleet.range[slot].at(0.5 * fleet.traits[slot].max_speed),
                    world.settings.sensing_radius);
    world.fast = world.fast || world.is_fast(slot);
  }
  world.valid = !world.selective && world.obstacles.setup.empty() &&
                world.settings.sensing_radius <= kFarthestTrusted;
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    world.valid =
        world.valid && is_valid(fleet.sensed(i)) && fleet.traits[i].max_speed <= kFarthestTrusted;
  }
  world.near = fleet.size() > 0 ? sum / static_cast<double>(fleet.size()) : 0.0;
}

void lay_out(World& world, Executor& executor) {
  Fleet& fleet = world.fleet;
  lay_out(fleet, world.settings.sensing_radius, world.near, world.most_nearest(), world.snapshot);
  const std::size_t count = fleet.size(), tiles = (count + kTileRobots - 1) / kTileRobots;
  parallel_for(executor, tiles, [&](std::size_t tile, std::size_t) {
    const std::size_t last = std::min((tile + 1) * kTileRobots, count);
    for (std::size_t i = tile * kTileRobots; i < last; ++i) {
      fleet.cell[i] = world.snapshot.cells.key(fleet.position[i]);
    }
  });
}

void take_snapshot(World& world, Executor& executor) {
  const std::size_t parts = executor.workers();
  prepare(world.fleet, world.layered, world.snapshot);
  parallel_for(executor, parts, [&](std::size_t part, std::size_t worker) {
    StageClock& clock = world.workers[worker].clock;
    clock.start();
    world.workers[part].crowding = take(world.fleet, part, parts, world.snapshot);
    clock.lap(Stage::index);
  });
  world.snapshot.crowding = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    world.snapshot.crowding += world.workers[part].crowding;
  }
}

void index(World& world, Executor& executor) {
  StageClock& clock = world.workers[0].clock;
  clock.start();
  if (world.changed) {
    find_ranges(world);
    find_walls(world);
    if (!world.statics.walls.empty()) make_room(world);
  }
  const bool due = world.steps >= world.next_layout;
  if (world.changed || due) lay_out(world, executor);
  if (due) world.next_layout = world.steps + kStepsInOrder;
  world.changed = false;
  world.obstacle_grid.build(world.obstacles.position, world.settings.sensing_radius);
  clock.lap(Stage::index);
  take_snapshot(world, executor);
  clock.start();
  if (!world.ways.passages.empty()) collect_claims(world, executor, world.claims);
  if (due && world.fleet.size() >= kFewestOrdered) {
    world.fleet.reorder(world.snapshot.grid.order(), executor);
    world.snapshot.grid.forget_order();
  }
  clock.lap(Stage::index);
}

// m: others farther away matter only if they are among the nearest.
double near_range(const World& world, std::size_t slot) {
  if (!world.senses.are_exact()) return world.settings.sensing_radius;
  if (!world.all_matter() && !world.selective) return -1.0;
  const Vec2 p = world.fleet.position[slot];
  const double everyone = world.settings.sensing_radius;
  const double farthest = std::max({std::abs(p.x), std::abs(p.y), everyone});
  // among movers it matters whether anybody decides at all
  if (world.fast || world.selective || !world.obstacles.setup.empty() ||
      !(farthest <= kMostRelevantPosition))
    return everyone;
  return world.fleet.range[slot].at(norm(world.fleet.velocity[slot]));
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

// The robot at a place of the snapshot; nothing where the one that looks does not mind it.
std::optional<Neighbor> sensed_at(const World& world, std::size_t place, const Conduct& own) {
  const Sensed& sensed = world.snapshot.sensed[place];
  const Conduct& conduct = world.fleet.conduct[world.snapshot.grid.order()[place]];
  const auto behavior = expected_of(conduct, own);
  if (conduct.parked || !behavior) return std::nullopt;
  const bool moves_on = *behavior == Behavior::moves_on;
  return Neighbor{.position = world.snapshot.grid.position(place),
                  .velocity = sensed.velocity,
                  .radius = sensed.radius,
                  .max_acceleration = sensed.max_acceleration,
                  .acceleration = moves_on ? world.snapshot.acceleration[place] : Vec2{},
                  .behavior = *behavior,
                  .priority = conduct.priority};
}

// The same among moving obstacles, robots first where distances are equal, and where robots are not
// all alike.
void append_one_by_one(const World& world, std::size_t slot, std::size_t query, Worker& worker) {
  const Vec2 position = world.fleet.position[slot];
  const Conduct& own = world.fleet.conduct[slot];
  NeighborColumns& to = worker.tile.neighbors;
  const std::size_t most =
      world.all_matter() ? std::numeric_limits<std::size_t>::max() : world.most_nearest();
  const std::span<const NeighborHit> robots = world.snapshot.grid.list(query, worker.search);
  const std::span<const NeighborHit> obstacles =
      world.obstacle_grid.gather(position, -1, most, worker.obstacles);
  const std::size_t first = to.count;
  to.reserve(first + std::min(robots.size() + obstacles.size(), most));
  auto robot = robots.begin(), obstacle = obstacles.begin();
  while (to.count - first < most && (robot != robots.end() || obstacle != obstacles.end())) {
    if (obstacle == obstacles.end() ||
        (robot != robots.end() && robot->distance_squared <= obstacle->distance_squared)) {
      if (const auto neighbor = sensed_at(world, (robot++)->place, own)) to.add(*neighbor);
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

// Fills the tile's neighbors: all that can matter within the sensing radius. Returns how many
// robots there was room for.
std::size_t sense(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  constexpr double kMargin = 1.125;  // for having moved since
  Fleet& fleet = world.fleet;
  const Snapshot& snapshot = world.snapshot;
  // of all, those are chosen later whom it minds
  const std::size_t nearest =
      world.selective ? std::numeric_limits<std::size_t>::max() : world.most_nearest();
  worker.queries.clear();
  for (const std::uint32_t slot : slots) {
    worker.queries.push_back({.position = fleet.position[slot],
                              .self = fleet.rank[slot],
                              .most = nearest,
                              .near = near_range(world, slot),
                              .far = world.settings.sensing_radius,
                              .guess = kMargin * static_cast<double>(fleet.nearest[slot])});
  }
  const std::size_t robots = snapshot.grid.find(worker.queries, kTileCandidates, worker.search);
  for (std::size_t i = 0; i < robots; ++i) {
    const std::size_t first = worker.tile.neighbors.count;
    if (!world.senses.are_exact()) {
      append_sighted(world, slots[i], i, worker);
    } else if (world.alike && world.obstacles.setup.empty()) {
      append(snapshot, worker.search.results[i], worker.search, worker.tile.neighbors);
    } else {
      append_one_by_one(world, slots[i], i, worker);
    }
    fleet.nearest[slots[i]] = reach_of_nearest(fleet.position[slots[i]], worker.search.results[i],
                                               nearest, snapshot, worker.search);
    const NeighborColumns& neighbors = worker.tile.neighbors;
    worker.tile.robots.neighbors.push_back(
        {&neighbors, first, neighbors.count - first, range_of(worker.queries[i])});
    worker.tile.trusted = worker.tile.trusted && is_trusted(world, slots[i]);
    if (worker.tile.neighbors.count >= kTileCandidates) return i + 1;  // of obstacles
  }
  return robots;
}

// Without those that are parked.
std::span<const std::uint32_t> deciding(const World& world, std::span<const std::uint32_t> slots,
                                        Worker& worker) {
  if (world.parked == 0) return slots;
  worker.deciding.clear();
  std::copy_if(slots.begin(), slots.end(), std::back_inserter(worker.deciding),
               [&](std::uint32_t slot) { return !world.fleet.conduct[slot].parked; });
  return worker.deciding;
}

void take_slots(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  worker.clock.start();
  while (!slots.empty()) {
    const std::size_t robots = sense(world, slots, worker);
    worker.clock.lap(Stage::search);
    plan_and_move(world, slots.first(robots), worker);
    slots = slots.subspan(robots);
  }
}

}  // namespace

void step(World& world) {
  const std::size_t robots = world.fleet.size();
  Executor& executor = executor_of(world);
  index(world, executor);
  world.torn = true;
  parallel_for(executor, (robots + kTileRobots - 1) / kTileRobots,
               [&](std::size_t tile, std::size_t worker) {
                 const std::size_t first = tile * kTileRobots;
                 const std::size_t count = std::min(kTileRobots, robots - first);
                 Worker& own = world.workers[worker];
                 take_slots(world,
                            deciding(world, world.snapshot.grid.order().subspan(first, count), own),
                            own);
               });
  world.fast = false;
  for (Worker& worker : world.workers) {
    world.fast = world.fast || worker.fast;
    worker.fast = false;
  }
  world.torn = false;
  world.obstacles.advance(world.settings.time_step);
  ++world.steps;
  world.senses.note(world.fleet, world.steps);
  if (world.workers[0].clock.is_on())
    world.robot_steps += static_cast<std::int64_t>(robots - world.parked);
}

}  // namespace avo
