// SPDX-License-Identifier: Apache-2.0
#include "sim/sensing/index.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "planner/stages/certify.h"
#include "sim/clocks.h"
#include "sim/host/external.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Steps for which robots that were put in order stay near their neighbors in memory. The smallest
// fleet that does not fit into the cache.
constexpr std::int64_t kStepsInOrder = 16;
constexpr std::size_t kFewestOrdered = 1024;

void lay_out(World& world, Executor& executor) {
  lay_out(world.fleet, world.sensing_radius, world.near, world.most_nearest(), world.snapshot);
  note_cells(world, executor);
}

void take_snapshot(World& world, Executor& executor) {
  const std::size_t parts = executor.workers();
  prepare(world.fleet, certificate_law(world.certified_planner()).step, world.snapshot);
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

// Brings the poses into the order of the cells, as Fleet::reorder() does with the robots.
void reorder_poses(Snapshot& snapshot) {
  if (snapshot.pose.empty()) return;
  std::vector<BrakingPose> sorted;
  for (const std::uint32_t slot : snapshot.grid.order()) sorted.push_back(snapshot.pose[slot]);
  snapshot.pose = std::move(sorted);
}

}  // namespace

void note_cells(World& world, Executor& executor) {
  Fleet& fleet = world.fleet;
  const std::size_t count = fleet.size(), tiles = (count + kTileRobots - 1) / kTileRobots;
  parallel_for(executor, tiles, [&](std::size_t tile, std::size_t) {
    const std::size_t last = std::min((tile + 1) * kTileRobots, count);
    for (std::size_t i = tile * kTileRobots; i < last; ++i) {
      fleet.cell[i] = world.snapshot.cells.key(fleet.position[i]);
    }
  });
}

void index(World& world, Executor& executor) {
  StageClock& clock = world.workers[0].clock;
  clock.start();
  if (world.changed) {
    world.summary = summary_of(world);
    find_external(world);
    find_ranges(world);
    find_walls(world);
    if (world.statics.has_walls) make_room(world);
    if (world.fleet.has_clocks || !world.fleet.pace.empty()) world.due.reserve(world.fleet.size());
  }
  find_shared_goals(world);
  const bool due = world.steps >= world.next_layout;
  if (world.changed || due) lay_out(world, executor);
  if (due) world.next_layout = world.steps + kStepsInOrder;
  foresee(world);
  world.changed = false;
  world.mover_grid.build(world.movers.position, world.sensing_radius);
  locate_outliers(world);
  clock.lap(Stage::index);
  take_snapshot(world, executor);
  clock.start();
  if (world.has_passages()) collect_claims(world, executor, world.claims);
  if (due && world.fleet.size() >= kFewestOrdered) {
    reorder_poses(world.snapshot);
    world.fleet.reorder(world.snapshot.grid.order(), executor, world.torn);
    world.snapshot.grid.forget_order();
  }
  clock.lap(Stage::index);
}

void look_at_present(World& world) {
  if (world.changed) find_walls(world);
  find_shared_goals(world);
  foresee(world);
  lay_out(world, world.serial);
  world.mover_grid.build(world.movers.position, world.sensing_radius);
  take_snapshot(world, world.serial);
}

}  // namespace avo::inline sim
