// SPDX-License-Identifier: Apache-2.0
// What the robots of a tile remember, and their motion.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "planner/decision.h"
#include "planner/scratch.h"
#include "planner/stages/execution.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// A robot that stays near a goal that others share brakes until it stands, and does not yield.
void stop(World& world, Worker& worker) {
  for (const std::uint32_t slot : worker.staying) {
    Plan& plan = world.fleet.plan[slot];
    if (plan.status == PlanStatus::overlapping) continue;
    const SafetyState state = plan.state;
    plan = stop_of(world, slot);
    plan.state = state;
    remember(plan, world.fleet.detour[slot]);
  }
  worker.staying.clear();
}

void count(const World& world, Worker& worker) {
  if (!worker.clock.is_on()) return;
  for (std::size_t k = 0; k < worker.tile.plan.size(); ++k) {
    worker.pairs += static_cast<std::int64_t>(
        planned_with(world.planner().options(), worker.tile.robots.neighbors[k]));
    worker.infeasible += worker.tile.plan[k]->violation > 0.0 ? 1 : 0;
  }
}

ModelStep step_by_model(const Fleet& fleet, std::size_t slot) {
  const RobotTraits& traits = fleet.traits[slot];
  const Flight* flight = fleet.flight(slot);
  return {fleet.own_model(slot),
          {planned_braking(traits), traits.max_speed},
          {fleet.position[slot], fleet.velocity[slot], fleet.heading[slot],
           flight != nullptr ? flight->circle : LoiterCircle{}},
          &fleet.plan[slot]};
}

void take_step(World& world, const Pace& pace, std::size_t slot, const ModelStep& step) {
  Fleet& fleet = world.fleet;
  const MotionState& next = step.result.next;
  if (Flight* flight = fleet.flight(slot); flight != nullptr) {
    flight->circle = next.circle;
    const double nearest = pass(*step.model, step.limits, step.state, *step.plan,
                                pace.response.time_step, fleet.goal[slot]);
    if (nearest <= world.arrival_distance(slot) && !fleet.told_velocity(slot))
      flight->has_arrived = true;
  }
  fleet.position[slot] = next.position;
  fleet.velocity[slot] = fleet.plan[slot].next_velocity = next.velocity;
  fleet.heading[slot] = next.heading;
  fleet.applied_acceleration[slot] = step.result.acceleration;
}

// Moves the robots of a tile that are not holonomic, some at a time.
void move_by_models(World& world, const Pace& pace, const Tile& tile) {
  std::array<ModelStep, kMostModelSteps> steps;
  std::array<std::uint32_t, kMostModelSteps> slots;
  for (std::size_t k = 0; k < tile.slot.size();) {
    std::size_t count = 0;
    for (; k < tile.slot.size() && count < steps.size(); ++k) {
      if (!world.fleet.traits[tile.slot[k]].has_model) continue;
      slots[count] = tile.slot[k];
      steps[count++] = step_by_model(world.fleet, tile.slot[k]);
    }
    advance_together(std::span(steps).first(count), pace.response.time_step);
    for (std::size_t n = 0; n < count; ++n) take_step(world, pace, slots[n], steps[n]);
  }
}

}  // namespace

void recall(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  Fleet& fleet = world.fleet;
  worker.travels.clear(), worker.has_stood.clear();
  for (const std::uint32_t slot : slots) {
    worker.tile.detour.push_back(&fleet.detour[slot]);
    worker.tile.plan.push_back(&fleet.plan[slot]);
  }
  for (std::size_t k = 0; k < slots.size() && !world.travels.empty(); ++k)
    worker.travels.push_back(&world.travels[static_cast<std::size_t>(fleet.rank[slots[k]])]);
  for (std::size_t k = 0; k < slots.size() && !world.shares_goal.empty(); ++k)
    worker.has_stood.push_back(&fleet.has_stood[slots[k]]);
}

void move(World& world, const Pace& pace, Worker& worker) {
  stop(world, worker);
  count(world, worker);
  Fleet& fleet = world.fleet;
  MovingColumns& moving = worker.moving;
  Tile& tile = worker.tile;
  tile.robots.count = tile.slot.size();
  for (std::size_t k = 0; k < tile.slot.size(); ++k) {
    // indices into lists that do not exist outside
    tile.plan[k]->neighbor = tile.plan[k]->wall = -1;
    const Vec2 v_new = tile.plan[k]->new_velocity;
    moving.new_x[k] = v_new.x, moving.new_y[k] = v_new.y;
  }
  std::uint64_t fast = advance(pace.response, moving, tile.robots);
  if (tile.robots.has_models) move_by_models(world, pace, tile);
  for (std::size_t k = 0; k < tile.slot.size(); ++k) {
    const std::uint32_t slot = tile.slot[k];
    if (fleet.traits[slot].has_model) {
      const std::uint64_t bit = std::uint64_t{1} << k;
      fast = world.is_fast(slot) ? fast | bit : fast & ~bit;
    } else {
      fleet.position[slot] = tile.robots.position(k);
      fleet.velocity[slot] = tile.plan[k]->next_velocity = tile.robots.velocity(k);
      fleet.applied_acceleration[slot] = moving.acceleration[k];
    }
    fleet.cell[slot] = world.snapshot.cells.key(fleet.position[slot]);
  }
  worker.fast = worker.fast || fast != 0;
  if (!fleet.has_clocks) return;
  for (const std::uint32_t slot : tile.slot) begin_step(world, slot);
}

}  // namespace avo::inline sim
