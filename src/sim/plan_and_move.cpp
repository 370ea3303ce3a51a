// SPDX-License-Identifier: Apache-2.0
// A tile of robots from what they sense to where they are next.
#include <algorithm>

#include "planner/scratch.h"
#include "sim/world.h"

namespace avo {
namespace {

// Where each robot of the tile would go, and what it knows of itself.
void set_out(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  Fleet& fleet = world.fleet;
  MovingColumns& moving = worker.moving;
  moving.count = slots.size();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::uint32_t slot = slots[k];
    moving.set(k, fleet.position[slot], fleet.velocity[slot], fleet.goal[slot], fleet.traits[slot]);
  }
  choose_ways(goal_law(world.planner), moving);

  Tile& tile = worker.tile;
  tile.robots.resize(slots.size());
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::uint32_t slot = slots[k];
    const RobotTraits& its = fleet.traits[slot];
    Robot& robot = tile.robots[k];
    robot.position = moving.position(k), robot.velocity = moving.velocity(k);
    robot.preferred_velocity = {moving.preferred_x[k], moving.preferred_y[k]};
    robot.radius = its.radius;
    robot.max_acceleration = its.max_acceleration, robot.max_speed = its.max_speed;
    robot.distance_to_goal = moving.distance[k];
    robot.car.reset();
    if (its.wheelbase > 0.0) robot.car = CarSetup{its.wheelbase, fleet.heading[slot]};
    tile.deciding.push_back(
        {{&robot, tile.neighbors_of(k), tile.trusted}, &fleet.detour[slot], &fleet.plan[slot]});
  }
}

void count(const World& world, Worker& worker) {
  if (!worker.clock.is_on()) return;
  const std::size_t most = world.most_nearest();
  for (const Deciding& each : worker.tile.deciding) {
    worker.pairs += static_cast<std::int64_t>(std::min(each.sensing.neighbors.size(), most));
    worker.infeasible += each.plan->violation > 0.0 ? 1 : 0;
  }
}

void move_car(World& world, std::size_t slot) {
  Fleet& fleet = world.fleet;
  const RobotTraits& its = fleet.traits[slot];
  const MotionStep step = advance_car(
      {fleet.position[slot], fleet.velocity[slot], fleet.heading[slot]}, fleet.plan[slot],
      {its.wheelbase, its.max_acceleration, its.max_speed}, world.settings.time_step);
  fleet.position[slot] = step.next.position;
  fleet.velocity[slot] = fleet.plan[slot].next_velocity = step.next.velocity;
  fleet.heading[slot] = step.next.heading;
  fleet.applied_acceleration[slot] = step.acceleration;
}

void move(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  Fleet& fleet = world.fleet;
  MovingColumns& moving = worker.moving;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Vec2 v_new = fleet.plan[slots[k]].new_velocity;
    moving.new_x[k] = v_new.x, moving.new_y[k] = v_new.y;
  }
  std::uint64_t fast = advance(world.response, moving);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::uint32_t slot = slots[k];
    if (worker.tile.robots[k].car) {
      move_car(world, slot);
      const std::uint64_t its = std::uint64_t{1} << k;
      fast = world.is_fast(slot) ? fast | its : fast & ~its;
    } else {
      fleet.position[slot] = moving.position(k);
      fleet.velocity[slot] = fleet.plan[slot].next_velocity = moving.velocity(k);
      fleet.applied_acceleration[slot] = moving.acceleration[k];
    }
    fleet.cell[slot] = world.snapshot.cells.key(fleet.position[slot]);
  }
  worker.fast = worker.fast || fast != 0;
}

}  // namespace

void plan_and_move(World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  set_out(world, slots, worker);
  worker.clock.lap(Stage::motion);
  Tile& tile = worker.tile;
  plan_together(world.planner, tile.deciding, PlanWorkspace::Scratch::of(worker.workspace),
                worker.clock);
  count(world, worker);
  move(world, slots, worker);
  tile.clear();
  worker.clock.lap(Stage::motion);
}

}  // namespace avo
