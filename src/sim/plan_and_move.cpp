// SPDX-License-Identifier: Apache-2.0
// Takes a tile of robots from their sensed neighbors to their next states.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "planner/decision.h"
#include "planner/execution.h"
#include "planner/scratch.h"
#include "robots/ahead.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/held_passages.h"
#include "sim/ties.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// m: neighbors come nearest first.
double nearest_of(const Neighbors& neighbors, Vec2 position) {
  if (neighbors.count == 0) return std::numeric_limits<double>::infinity();
  return norm(neighbors[0].position - position);
}

// Robots that do not know exactly where they are see walls and goals with that error.
void lose_places(const World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  worker.lost.clear();
  if (!(world.settings.sensing.localization.position > 0.0)) return;
  for (const std::uint32_t slot : slots) worker.lost.push_back(own_error(world, slot));
}

void list_walls(const World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  const WallGrid& grid = world.statics.grid;
  std::size_t all = 0;
  for (const std::uint32_t slot : slots) {
    worker.tile.walls.push_back(grid.near(world.fleet.position[slot]));
    all += worker.tile.walls.back().size();
  }
  if (worker.lost.empty()) return;
  worker.walls.clear();
  worker.walls.reserve(all);  // so that no span is invalidated
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::size_t first = worker.walls.size();
    for (const Wall& wall : worker.tile.walls[k])
      worker.walls.push_back(moved(wall, -worker.lost[k]));
    worker.tile.walls[k] = std::span(worker.walls).subspan(first);
  }
}

// Around walls: the heading to the next point of each robot's route, as passages allow.
void follow_ways(World& world, const Pace& pace, std::span<const std::uint32_t> slots,
                 Worker& worker) {
  const Fleet& fleet = world.fleet;
  worker.headings.clear();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::uint32_t slot = slots[k];
    Travel& travel = world.ways.travels[static_cast<std::size_t>(fleet.rank[slot])];
    const Vec2 end = travel.heads_for(fleet.goal[slot]);
    const Vec2 p =
        worker.lost.empty() ? fleet.position[slot] : fleet.position[slot] + worker.lost[k];
    Heading heading = follow(travel, p, end, fleet.traits[slot], own_way_of(fleet, slot),
                             looks_around(fleet.id[slot], decisions_of(world, slot)), worker.legs);
    if (!world.shares_goal.empty()) worker.headings.push_back(heading);
    if (!world.ways.passages.empty()) {
      const RobotTraits& traits = fleet.traits[slot];
      const double nearest = nearest_of(worker.tile.robots.neighbors[k], fleet.position[slot]);
      const bool in_company = is_in_company(traits.radius, nearest);
      const double left = norm(heading.goal - p);
      heading = heed_passages(world, world.claims, slot, travel, heading, nearest);
      const bool back = goes_back(world, slot, travel);
      const double time = in_company || back ? pace.planner.options().time_step : 0.0;
      go_around_held(world, slot, left, time, travel, worker.legs);
      if (back) go_back(p, in_company, heading);
      if (!world.shares_goal.empty()) worker.headings[k].yields = heading.yields;
    }
    if (world.ways.goes_around_movers())
      heading = beside_resting(world.ways.resting(), heading, p, end, fleet.traits[slot].radius);
    worker.moving.goal_x[k] = heading.goal.x, worker.moving.goal_y[k] = heading.goal.y;
    worker.moving.preferred_speed[k] = heading.preferred_speed;
  }
}

// What the robot sees of others at its goal, which it shares with some.
Occupied& look_at_goal(const Seeker& seeker, const Neighbors& neighbors, Worker& worker) {
  worker.occupied.clear();
  worker.occupied.add(seeker, neighbors);
  return worker.occupied;
}

// Sets the targets of the discs. The place that reaches a goal is not the center of every disc, and
// not all robots reach shared goals. A robot with an error of its own place sees its goal
// elsewhere.
void aim_discs(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  MovingColumns& moving = worker.moving;
  Fleet& fleet = world.fleet;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::uint32_t slot = slots[k];
    const Vec2 aim{moving.goal_x[k], moving.goal_y[k]};
    const Vec2 lost = worker.lost.empty() ? Vec2{} : worker.lost[k];
    Vec2 goal = disc_goal(fleet, slot, aim, world.end_of(slot)) - lost;
    if (shares_room(world, slot)) {
      const Heading heading = world.ways.empty() ? straight_to(fleet.goal[slot], fleet.traits[slot])
                                                 : worker.headings[k];
      const Seeker seeker = seeker_of(world, slot, heading, lost);
      Occupied& occupied = look_at_goal(seeker, worker.tile.robots.neighbors[k], worker);
      const AtSharedGoal decided = at_shared_goal(world, slot, seeker, occupied,
                                                  worker.tile.walls_of(k), fleet.detour[slot]);
      if (decided.heads_for)
        goal = *decided.heads_for, moving.preferred_speed[k] = heading.preferred_speed;
      fleet.has_stood[slot] = decided.has_stood ? 1 : 0;
      if (decided.stops) worker.staying.push_back(slot);
    }
    moving.goal_x[k] = goal.x, moving.goal_y[k] = goal.y;
  }
}

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

// Airplanes do not slow down at their goals, and circle after they have passed them.
void set_courses(const Fleet& fleet, std::span<const std::uint32_t> slots, Worker& worker) {
  RobotColumns& robots = worker.tile.robots;
  const MovingColumns& moving = worker.moving;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Flight* flight = fleet.flight(slots[k]);
    if (flight == nullptr) continue;
    const Vec2 v = course_of(*flight, robots.position(k), {moving.goal_x[k], moving.goal_y[k]},
                             moving.preferred_speed[k]);
    robots.preferred_x[k] = v.x, robots.preferred_y[k] = v.y;
  }
}

void break_ties(const Fleet& fleet, Tile& tile) {
  const NeighborColumns& columns = tile.neighbors;
  for (std::size_t k = 0; k < tile.slot.size(); ++k) {
    const Neighbors& neighbors = tile.robots.neighbors[k];
    Detour& detour = *tile.detour[k];
    if (detour.congestion != 0.0F || neighbors.count < 2) continue;
    const auto squared = [&](std::size_t at) {
      return norm_squared(tile.robots.position(k) - Vec2{columns.x[at], columns.y[at]});
    };
    break_tie(fleet.id[tile.slot[k]], squared(neighbors.first), squared(neighbors.first + 1),
              detour);
  }
}

// Fills in what the robots of the tile know of themselves, and their preferred velocities.
void set_out(World& world, const Pace& pace, std::span<const std::uint32_t> slots, Worker& worker) {
  Fleet& fleet = world.fleet;
  Tile& tile = worker.tile;
  RobotColumns& robots = tile.robots;
  robots.reserve(slots.size());
  robots.count = slots.size();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::uint32_t slot = slots[k];
    const RobotTraits& traits = fleet.traits[slot];
    robots.x[k] = fleet.position[slot].x, robots.y[k] = fleet.position[slot].y;
    robots.v_x[k] = fleet.velocity[slot].x, robots.v_y[k] = fleet.velocity[slot].y;
    robots.radius[k] = traits.radius;
    robots.max_acceleration[k] = traits.max_acceleration, robots.max_speed[k] = traits.max_speed;
    robots.max_braking[k] = traits.max_braking;
    robots.heading[k] = fleet.heading[slot];
    robots.priority[k] = fleet.conduct[slot].priority;
    if (!fleet.flights.empty()) {
      const Flight* own = fleet.flight(slot);
      robots.loiter.push_back(own != nullptr ? &own->circle : nullptr);
    }
    worker.moving.goal_x[k] = fleet.goal[slot].x, worker.moving.goal_y[k] = fleet.goal[slot].y;
    worker.moving.preferred_speed[k] = traits.preferred_speed;
    fleet.detour[slot].goal_taken = false;
    tile.detour.push_back(&fleet.detour[slot]);
    tile.plan.push_back(&fleet.plan[slot]);
    tile.slot.push_back(slot);
  }
  if (pace.planner.options().method == Method::avo) break_ties(fleet, tile);
  robots.model.assign(slots.size(), nullptr);
  for (std::size_t k = 0; k < slots.size() && !fleet.models.empty(); ++k) {
    robots.model[k] = fleet.own_model(slots[k]);
    robots.has_models = robots.has_models || robots.model[k] != nullptr;
  }
  if (robots.has_models) look_ahead(robots);
  lose_places(world, slots, worker);
  if (!world.statics.walls.empty()) list_walls(world, slots, worker);
  if (!world.ways.empty()) follow_ways(world, pace, slots, worker);
  if (robots.has_models || !world.shares_goal.empty() || !worker.lost.empty())
    aim_discs(world, slots, worker);
  choose_ways(pace.response, worker.moving, robots);
  if (!fleet.flights.empty()) set_courses(fleet, slots, worker);
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
    if (nearest <= world.settings.arrival_distance) flight->has_arrived = true;
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

void move(World& world, const Pace& pace, Worker& worker) {
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

}  // namespace

void plan_and_move(World& world, const Pace& pace, std::span<const std::uint32_t> slots,
                   Worker& worker) {
  set_out(world, pace, slots, worker);
  worker.clock.lap(Stage::motion);
  plan_together(pace.planner, worker.tile, PlanWorkspace::Scratch::of(worker.workspace),
                worker.clock);
  stop(world, worker);
  count(world, worker);
  move(world, pace, worker);
  worker.tile.clear();
  worker.clock.lap(Stage::motion);
}

}  // namespace avo::inline sim
