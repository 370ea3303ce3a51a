// SPDX-License-Identifier: Apache-2.0
// The sensing-acting cycle of a fleet (paper §IV-D): all robots decide from the same snapshot, each
// alone, and move.
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "planner/scratch.h"
#include "robots/model.h"
#include "sim/bases/bases.h"
#include "sim/clocks.h"
#include "sim/host/edits.h"
#include "sim/host/external.h"
#include "sim/host/host_motion.h"
#include "sim/sensing/index.h"
#include "sim/sensing/sense.h"
#include "sim/simulation_state.h"

namespace avo::inline sim {
namespace {

Executor& executor_of(World& world) {
  if (world.fleet.size() < kFewestParallel) return world.serial;
  return *world.executor;
}

// The slots of the robots that decide.
std::span<const std::uint32_t> deciding(const World& world, std::span<const std::uint32_t> slots,
                                        Worker& worker) {
  if (world.summary.idle == 0) return slots;
  worker.deciding.clear();
  std::copy_if(slots.begin(), slots.end(), std::back_inserter(worker.deciding),
               [&](std::uint32_t slot) { return world.fleet.decides(slot); });
  return worker.deciding;
}

// Decides for these robots, which all have one pace and known neighbors, and moves them.
void plan_and_move(World& world, const Pace& pace, std::span<const std::uint32_t> slots,
                   Worker& worker) {
  recall(world, slots, worker);
  set_out(world, pace, world.claims, slots, worker);
  if (!world.external.chosen.empty()) take_chosen(world, slots, worker);
  worker.clock.lap(Stage::motion);
  plan_together(pace.planner, worker.tile, PlanWorkspace::Scratch::of(worker.workspace),
                worker.clock);
  move(world, pace, worker);
  worker.tile.clear();
  worker.clock.lap(Stage::motion);
}

void take_slots(World& world, const Pace& pace, std::span<const std::uint32_t> slots,
                Worker& worker) {
  worker.clock.start();
  while (!slots.empty()) {
    const std::size_t robots = sense(world, slots, worker);
    worker.clock.lap(Stage::search);
    plan_and_move(world, pace, slots.first(robots), worker);
    slots = slots.subspan(robots);
  }
}

void take_tiles(World& world, const Pace& pace, std::span<const std::uint32_t> slots,
                Executor& executor) {
  parallel_for(executor, (slots.size() + kTileRobots - 1) / kTileRobots,
               [&](std::size_t tile, std::size_t worker) {
                 const std::size_t first = tile * kTileRobots;
                 const std::size_t count = std::min(kTileRobots, slots.size() - first);
                 Worker& own = world.workers[worker];
                 take_slots(world, pace, deciding(world, slots.subspan(first, count), own), own);
               });
}

// Takes the robots that are due, robots of one pace together.
void take_by_pace(World& world, Executor& executor) {
  std::vector<std::uint32_t>& due = world.due;
  const auto pace_of = [&](std::uint32_t slot) { return world.fleet.pace_of(slot); };
  std::sort(due.begin(), due.end(), [&](std::uint32_t a, std::uint32_t b) {
    return pace_of(a) != pace_of(b) ? pace_of(a) < pace_of(b) : a < b;
  });
  std::span<const std::uint32_t> left = due;
  while (!left.empty()) {
    const auto last = std::find_if(left.begin(), left.end(), [&](std::uint32_t slot) {
      return pace_of(slot) != pace_of(left.front());
    });
    const auto count = static_cast<std::size_t>(last - left.begin());
    take_tiles(world, world.paces[pace_of(left.front())], left.first(count), executor);
    left = left.subspan(count);
  }
}

// Prepares an instant at which all robots are examined. Robots that decided since they were filed
// did so in a snapshot of one cell.
void assemble(World& world, Executor& executor) {
  const Fleet& fleet = world.fleet;
  catch_up(world);
  unfile(world);
  note_cells(world, executor);
  if (world.changed) make_agenda(world);
  world.summary.is_fast = false;
  for (std::size_t slot = 0; slot < fleet.size() && !world.summary.is_fast; ++slot)
    world.summary.is_fast = !fleet.is_parked(slot) && world.is_fast(slot);
}

void collect_due(World& world) {
  world.due.clear();
  for (const std::uint32_t rank : world.agenda.now) world.due.push_back(world.fleet.slot_of[rank]);
}

// Robots decide where their own steps end now; then all move on to the next instant.
void step_freely(World& world, Executor& executor) {
  collect_due(world);
  take_by_pace(world, executor);
  file(world);
  carry_on(world, next_instant(world));
}

// The same where only a few robots decide: each uses the robots near it.
void step_near(World& world) {
  Worker& worker = world.workers[0];
  worker.clock.start();
  find_shared_goals(world);
  if (!world.movers.setup.empty())
    world.mover_grid.build(world.movers.position, world.sensing_radius);
  worker.clock.lap(Stage::index);
  world.summary.is_fast = false;
  collect_due(world);
  for (const std::uint32_t slot : world.due) put_in_place(world, slot);
  for (const std::uint32_t& slot : world.due) {
    worker.clock.start();
    find_near(world, slot);
    worker.clock.lap(Stage::index);
    take_slots(world, world.pace(slot), {&slot, 1}, worker);
  }
  for (const std::uint32_t slot : world.due) renew_step(world, slot);
  carry_on(world, next_instant(world));
}

// A step of all robots, where the clock is common.
void step_together(World& world, Executor& executor) {
  const std::span<const std::uint32_t> all = world.snapshot.grid.order();
  if (world.fleet.pace.empty()) {
    take_tiles(world, world.paces.front(), all, executor);
  } else {
    world.due.assign(all.begin(), all.end());
    take_by_pace(world, executor);
  }
  move_as_told(world);
  const double time_step = world.settings.time_step;
  world.movers.advance(time_step, static_cast<double>(world.steps + 1) * time_step);
}

// Removes the robots that have passed their goals, and do not stay.
void leave(World& world) {
  const Fleet& fleet = world.fleet;
  for (std::size_t rank = fleet.flights.size(); rank > 0; --rank) {
    const std::uint32_t slot = fleet.slot_of[rank - 1];
    const Flight* own = fleet.flight(slot);
    if (own != nullptr && own->has_arrived && model_traits(*fleet.own_model(slot)).leaves_at_goal)
      remove_robot(world, fleet.id[slot]);
  }
}

}  // namespace

void step(World& world) {
  leave(world);
  forget(world.bystanders);
  Executor& executor = executor_of(world);
  const bool is_free = world.fleet.has_clocks, near = is_free && knows_near(world);
  if (is_free && !near) assemble(world, executor);
  if (!near) index(world, executor);
  if (!world.external.ranks.empty()) choose_externally(world, executor);
  world.torn = true;
  bool fast = false;
  std::size_t decisions = world.fleet.size() - world.summary.idle;
  if (is_free) {
    near ? step_near(world) : step_freely(world, executor);
    decisions = world.due.size();
  } else {
    step_together(world, executor);
  }
  go_around_resting(world);
  note_resting(world);
  for (Worker& worker : world.workers) {
    fast = fast || worker.fast;
    worker.fast = false;
  }
  if (!is_free) world.summary.is_fast = fast;
  world.torn = false;
  ++world.steps;
  if (!world.fleet.bases.are_exact()) move_bases(world);
  if (!world.senses.are_exact()) {
    catch_up(world);
    world.senses.note(world.fleet, world.steps);
  }
  if (world.workers[0].clock.is_on()) world.robot_steps += static_cast<std::int64_t>(decisions);
}

}  // namespace avo::inline sim

namespace avo {

void Simulation::step() {
  require_whole(state_->to_change(), "Simulation::step");
  lead_teams(*this, state_->settings.teams);
  state_->forget_views();
  state_->forget_discs();
  if (decide_again(*state_)) state_->forget_robots();
  const std::size_t robots = state_->fleet.size();
  avo::step(*state_);
  if (state_->fleet.size() != robots) state_->forget_robots();
}

}  // namespace avo
