// SPDX-License-Identifier: Apache-2.0
// The sensing-acting cycle of a fleet (paper §IV-D): all robots decide from the same snapshot, each
// alone, and move.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
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

std::size_t threads_of(const World& world) {
  return world.fleet.size() < kFewestParallel ? 1 : world.workers.size();
}

bool is_fast(const World& world, std::size_t slot) {
  const double limit = (1.0 + kSpeedRounding) * world.fleet.traits[slot].max_speed;
  return !(norm_squared(world.fleet.velocity[slot]) <= limit * limit);
}

// Whether whomever it senses is valid, however all have moved since they were looked at.
bool is_trusted(const World& world, std::size_t slot) {
  const Vec2 p = world.fleet.position[slot];
  return world.valid && !world.fast && std::abs(p.x) <= kFarthestTrusted &&
         std::abs(p.y) <= kFarthestTrusted;
}

// How far each robot has to look, as long as none is fast.
void find_ranges(World& world) {
  Fleet& fleet = world.fleet;
  const auto limits = [&](std::size_t slot) {
    const RobotTraits& its = fleet.traits[slot];
    Robot robot;
    robot.radius = its.radius;
    robot.max_acceleration = its.max_acceleration;
    robot.max_speed = its.max_speed;
    return robot;
  };
  Peers peers;
  for (std::size_t i = 0; i < fleet.size(); ++i) include(peers, world.planner, limits(i));
  double sum = 0.0;
  world.fast = false;
  for (const std::uint32_t slot : fleet.slot_of) {
    fleet.range[slot] = relevant_range(world.planner, limits(slot), peers);
    sum += std::min(fleet.range[slot], world.settings.sensing_radius);
    world.fast = world.fast || is_fast(world, slot);
  }
  world.valid = world.obstacles.setup.empty() && world.settings.sensing_radius <= kFarthestTrusted;
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    world.valid =
        world.valid && is_valid(fleet.sensed(i)) && fleet.traits[i].max_speed <= kFarthestTrusted;
  }
  world.near = fleet.size() > 0 ? sum / static_cast<double>(fleet.size()) : 0.0;
}

void lay_out(World& world, std::size_t threads) {
  Fleet& fleet = world.fleet;
  lay_out(fleet, world.settings.sensing_radius, world.near, world.most_nearest(), world.snapshot);
  const std::size_t count = fleet.size(), tiles = (count + kTileRobots - 1) / kTileRobots;
  parallel_for(tiles, threads, [&](std::size_t tile, std::size_t) {
    const std::size_t last = std::min((tile + 1) * kTileRobots, count);
    for (std::size_t i = tile * kTileRobots; i < last; ++i) {
      fleet.cell[i] = world.snapshot.cells.key(fleet.position[i]);
    }
  });
}

void take_snapshot(World& world, std::size_t threads) {
  prepare(world.fleet, world.snapshot);
  parallel_for(threads, threads, [&](std::size_t part, std::size_t worker) {
    StageClock& clock = world.workers[worker].clock;
    clock.start();
    world.workers[part].crowding = take(world.fleet, part, threads, world.snapshot);
    clock.lap(Stage::index);
  });
  world.snapshot.crowding = 0;
  for (std::size_t part = 0; part < threads; ++part) {
    world.snapshot.crowding += world.workers[part].crowding;
  }
}

void index(World& world, std::size_t threads) {
  StageClock& clock = world.workers[0].clock;
  clock.start();
  if (world.changed) find_ranges(world);
  const bool due = world.steps >= world.next_layout;
  if (world.changed || due) lay_out(world, threads);
  if (due) world.next_layout = world.steps + kStepsInOrder;
  world.changed = false;
  world.obstacle_grid.build(world.obstacles.position, world.settings.sensing_radius);
  clock.lap(Stage::index);
  take_snapshot(world, threads);
  clock.start();
  if (due && world.fleet.size() >= kFewestOrdered) {
    world.fleet.reorder(world.snapshot.grid.order(), threads);
    world.snapshot.grid.forget_order();
  }
  clock.lap(Stage::index);
}

// m: others farther away matter only if they are among the nearest.
double near_range(const World& world, std::size_t slot) {
  if (!world.all_matter()) return -1.0;
  const Vec2 p = world.fleet.position[slot];
  const double everyone = world.settings.sensing_radius;
  const double farthest = std::max({std::abs(p.x), std::abs(p.y), everyone});
  if (world.fast || !(farthest <= kMostRelevantPosition)) return everyone;
  return world.fleet.range[slot];
}

void append(const World& world, std::span<const NeighborHit> robots, NeighborColumns& to) {
  const Snapshot& snapshot = world.snapshot;
  std::size_t i = to.count;
  for (const NeighborHit& hit : robots) {
    const Vec2 p = snapshot.grid.position(hit.place);
    const Sensed& sensed = snapshot.sensed[hit.place];
    to.x[i] = p.x, to.y[i] = p.y;
    to.v_x[i] = sensed.velocity.x, to.v_y[i] = sensed.velocity.y;
    to.radius[i] = sensed.radius, to.max_acceleration[i] = sensed.max_acceleration;
    ++i;
  }
  to.count = i;
}

// Appends the neighbors of a robot to those of the tile: all that can matter within the sensing
// radius, nearest first (robots first and by id where distances are equal).
void sense(const World& world, std::uint32_t slot, Worker& worker) {
  const Vec2 position = world.fleet.position[slot];
  const double radius = world.settings.sensing_radius;
  const std::size_t nearest = world.most_nearest();
  const std::span<const NeighborHit> robots = world.snapshot.grid.find(
      {position, world.fleet.rank[slot], nearest, near_range(world, slot), radius, worker.guess},
      worker.robots);
  // whoever comes next has its neighbors about as far away
  constexpr double kMargin = 1.25 * 1.25;
  worker.guess =
      robots.size() < nearest ? radius : std::sqrt(kMargin * robots[nearest - 1].distance_squared);
  NeighborColumns& neighbors = worker.tile.neighbors;
  const std::size_t most = world.all_matter() ? std::numeric_limits<std::size_t>::max() : nearest;
  const std::span<const NeighborHit> obstacles =
      world.obstacle_grid.gather(position, -1, most, worker.obstacles);
  const std::size_t end = neighbors.count + std::min(robots.size() + obstacles.size(), most);
  neighbors.reserve(end);
  if (obstacles.empty()) return append(world, robots, neighbors);
  auto robot = robots.begin(), obstacle = obstacles.begin();
  while (neighbors.count < end) {
    if (obstacle == obstacles.end() ||
        (robot != robots.end() && robot->distance_squared <= obstacle->distance_squared)) {
      append(world, {robot++, 1}, neighbors);
    } else {
      neighbors.add(world.obstacles.sensed(static_cast<std::size_t>((obstacle++)->index)));
    }
  }
}

void count(const World& world, Worker& worker) {
  if (!worker.clock.is_on()) return;
  const std::size_t most = world.most_nearest();
  for (std::size_t k = 0; k < worker.tile.size(); ++k) {
    worker.pairs += static_cast<std::int64_t>(std::min(worker.tile.neighbors_of(k).size(), most));
    worker.infeasible += worker.tile.plans[k].violation > 0.0 ? 1 : 0;
  }
}

void move(World& world, std::size_t slot, Worker& worker) {
  Fleet& fleet = world.fleet;
  const RobotTraits& its = fleet.traits[slot];
  const MotionState state{fleet.position[slot], fleet.velocity[slot], fleet.heading[slot]};
  const MotionStep step = its.wheelbase > 0.0
                              ? advance_car(state, fleet.plan[slot],
                                            {its.wheelbase, its.max_acceleration, its.max_speed},
                                            world.settings.time_step)
                              : advance(state, fleet.plan[slot], world.response);
  fleet.position[slot] = step.next.position;
  fleet.velocity[slot] = step.next.velocity;
  fleet.heading[slot] = step.next.heading;
  fleet.applied_acceleration[slot] = step.acceleration;
  fleet.cell[slot] = world.snapshot.cells.key(step.next.position);
  worker.fast = worker.fast || is_fast(world, slot);
}

// Decides for the robots of the tile, whose neighbors are known, moves them, and empties it.
void plan_and_move(World& world, Worker& worker) {
  Tile& tile = worker.tile;
  for (const std::uint32_t slot : worker.slots) {
    tile.robots.push_back(world.robot(slot));
    tile.detours.push_back(world.fleet.detour[slot]);
  }
  worker.clock.lap(Stage::motion);
  if (world.alone()) {
    tile.plans.resize(1);
    tile.plans[0] =
        world.planner.plan_among_obstacles(tile.robots[0], tile.list_neighbors_of(0), worker.plan);
    worker.clock.lap(Stage::program);
  } else {
    plan_tile(world.planner, tile, worker.plan, worker.clock);
  }
  count(world, worker);
  for (std::size_t k = 0; k < tile.size(); ++k) {
    const std::uint32_t slot = worker.slots[k];
    world.fleet.plan[slot] = tile.plans[k];
    world.fleet.detour[slot] = tile.detours[k];
    move(world, slot, worker);
  }
  tile.clear();
  worker.slots.clear();
  worker.clock.lap(Stage::motion);
}

void take_places(World& world, std::size_t first, std::size_t last, Worker& worker) {
  worker.clock.start();
  const std::span<const std::uint32_t> order = world.snapshot.grid.order();
  for (std::size_t place = first; place < last; ++place) {
    const std::uint32_t slot = order[place];
    sense(world, slot, worker);
    worker.tile.first.push_back(worker.tile.neighbors.count);
    worker.tile.trusted = worker.tile.trusted && is_trusted(world, slot);
    worker.slots.push_back(slot);
    if (worker.tile.neighbors.count < kTileNeighbors && place + 1 < last) continue;
    worker.clock.lap(Stage::search);
    plan_and_move(world, worker);
  }
}

}  // namespace

void step(World& world) {
  const std::size_t robots = world.fleet.size(), threads = threads_of(world);
  index(world, threads);
  parallel_for((robots + kTileRobots - 1) / kTileRobots, threads,
               [&](std::size_t tile, std::size_t worker) {
                 take_places(world, tile * kTileRobots, std::min((tile + 1) * kTileRobots, robots),
                             world.workers[worker]);
               });
  world.fast = false;
  for (Worker& worker : world.workers) {
    world.fast = world.fast || worker.fast;
    worker.fast = false;
  }
  world.obstacles.advance(world.settings.time_step);
  ++world.steps;
  if (world.workers[0].clock.is_on()) world.robot_steps += static_cast<std::int64_t>(robots);
}

}  // namespace avo
