// SPDX-License-Identifier: Apache-2.0
#include "sim/host/external.h"

#include <algorithm>
#include <string>

#include "avo/error.h"
#include "core/plane.h"
#include "core/ranges.h"
#include "sim/scene/edit_checks.h"
#include "sim/sensing/sense.h"
#include "sim/world.h"

namespace avo::inline sim {

void BatchColumns::clear() {
  id.clear(), robot.clear(), goal.clear();
  neighbor.clear(), wall.clear();
  first_neighbor.assign(1, 0), first_wall.assign(1, 0);
}

void BatchColumns::add(RobotId own_id, const Robot& own, Vec2 own_goal,
                       std::span<const Neighbor> neighbors, std::span<const Wall> walls) {
  id.push_back(own_id), robot.push_back(own), goal.push_back(own_goal);
  neighbor.insert(neighbor.end(), neighbors.begin(), neighbors.end());
  wall.insert(wall.end(), walls.begin(), walls.end());
  first_neighbor.push_back(neighbor.size()), first_wall.push_back(wall.size());
}

void BatchColumns::append(const BatchColumns& other) {
  const auto add_all = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  const auto add_ends = [](auto& to, const auto& from) {
    const std::size_t before = to.back();
    for (std::size_t k = 1; k < from.size(); ++k) to.push_back(before + from[k]);
  };
  add_all(id, other.id), add_all(robot, other.robot), add_all(goal, other.goal);
  add_all(neighbor, other.neighbor), add_all(wall, other.wall);
  add_ends(first_neighbor, other.first_neighbor), add_ends(first_wall, other.first_wall);
}

namespace {

void require_function(const World& world) {
  if (world.settings.external) return;
  throw Error("external_method " + world.settings.external_method +
              ": found no function, must have one (Scenario::external, or set_external())");
}

// Robots decide from copies of what they remember, so that the step itself finds it unchanged.
struct Memories {
  std::vector<Detour> detour;
  std::vector<Travel> travels;
  std::vector<std::uint8_t> has_stood;

  Memories(const World& world, std::span<const std::uint32_t> slots) {
    for (const std::uint32_t slot : slots) {
      const auto rank = static_cast<std::size_t>(world.fleet.rank[slot]);
      detour.push_back(world.fleet.detour[slot]);
      if (!world.travels.empty()) travels.push_back(world.travels[rank]);
      has_stood.push_back(world.fleet.has_stood[slot]);
    }
  }
  void lend(Worker& worker) {
    worker.travels.clear(), worker.has_stood.clear();
    for (Detour& own : detour) worker.tile.detour.push_back(&own);
    for (Travel& own : travels) worker.travels.push_back(&own);
    for (std::uint8_t& own : has_stood) worker.has_stood.push_back(&own);
  }
};

// Adds what the first robots know that one tile has room for; returns their number.
std::size_t look(World& world, std::span<const std::uint32_t> slots, Worker& worker,
                 BatchColumns& part) {
  const std::size_t robots = sense(world, slots, worker);
  const std::span<const std::uint32_t> seen = slots.first(robots);
  Memories memories(world, seen);
  memories.lend(worker);
  set_out(world, world.pace(seen.front()), world.claims, seen, worker);
  const Fleet& fleet = world.fleet;
  std::vector<Neighbor> neighbors;
  for (std::size_t k = 0; k < robots; ++k) {
    list(worker.tile.robots.neighbors[k], neighbors);
    Robot robot = worker.tile.robots.robot(k);
    robot.max_braking = max_braking_of(fleet.traits[seen[k]]);
    part.add(fleet.id[seen[k]], robot, fleet.goal[seen[k]], neighbors, worker.tile.walls_of(k));
  }
  worker.staying.clear();
  worker.tile.clear();
  return robots;
}

// Divides the robots into tiles of one pace.
void lay_tiles(const World& world, ExternalChoices& own) {
  own.tiles.clear();
  std::span<const std::uint32_t> left = own.slots;
  while (!left.empty()) {
    std::size_t count = 1;
    while (count < std::min(left.size(), kTileRobots) &&
           world.fleet.pace_of(left[count]) == world.fleet.pace_of(left.front()))
      ++count;
    own.tiles.push_back(left.first(count));
    left = left.subspan(count);
  }
  own.parts.resize(std::max(own.parts.size(), own.tiles.size()));
}

void collect_batch(World& world, Executor& executor) {
  ExternalChoices& own = world.external;
  own.slots.clear();
  for (const std::size_t rank : own.ranks) own.slots.push_back(world.fleet.slot_of[rank]);
  lay_tiles(world, own);
  parallel_for(executor, own.tiles.size(), [&](std::size_t tile, std::size_t worker) {
    std::span<const std::uint32_t> left = own.tiles[tile];
    own.parts[tile].clear();
    while (!left.empty())
      left = left.subspan(look(world, left, world.workers[worker], own.parts[tile]));
  });
  own.all.clear();
  for (std::size_t k = 0; k < own.tiles.size(); ++k) own.all.append(own.parts[k]);
}

// Tells that the function runs, also where it throws.
class AskingGuard {
 public:
  explicit AskingGuard(bool& is_asked) : is_asked_(is_asked) { is_asked_ = true; }
  ~AskingGuard() { is_asked_ = false; }
  AskingGuard(const AskingGuard&) = delete;
  AskingGuard& operator=(const AskingGuard&) = delete;

 private:
  bool& is_asked_;
};

void choose(const World& world, const BatchColumns& all, std::vector<Vec2>& velocities) {
  require_function(world);
  velocities.clear();
  for (const Robot& robot : all.robot) velocities.push_back(robot.preferred_velocity);
  const double time_step = world.settings.time_step;
  world.settings.external({.time = static_cast<double>(world.steps) * time_step,
                           .time_step = time_step,
                           .id = all.id,
                           .robot = all.robot,
                           .goal = all.goal,
                           .first_neighbor = all.first_neighbor,
                           .first_wall = all.first_wall,
                           .neighbor = all.neighbor,
                           .wall = all.wall},
                          velocities);
  for (std::size_t k = 0; k < velocities.size(); ++k)
    require(
        "external_method " + world.settings.external_method + ": velocity of " + name_of(all.id[k]),
        velocities[k], "m/s");
}

}  // namespace

void find_external(World& world) {
  ExternalChoices& own = world.external;
  own.ranks.clear(), own.chosen.clear();
  for (std::size_t rank = 0; rank < world.fleet.size(); ++rank) {
    const std::uint32_t slot = world.fleet.slot_of[rank];
    if (is_external(world.fleet.conduct[slot].method) && world.fleet.decides(slot))
      own.ranks.push_back(rank);
  }
}

void choose_externally(World& world, Executor& executor) {
  ExternalChoices& own = world.external;
  collect_batch(world, executor);
  {
    const AskingGuard asked(own.is_asked);
    choose(world, own.all, own.velocities);
  }
  own.chosen.resize(world.fleet.size());
  for (std::size_t k = 0; k < own.slots.size(); ++k) own.chosen[own.slots[k]] = own.velocities[k];
}

void take_chosen(const World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  RobotColumns& robots = worker.tile.robots;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    if (!is_external(world.fleet.conduct[slots[k]].method) || world.waits_to_start(slots[k]))
      continue;
    const Vec2 v = world.external.chosen[slots[k]];
    // a choice of its own says nothing of an approach to the goal
    if (v != Vec2{robots.preferred_x[k], robots.preferred_y[k]})
      robots.distance_to_goal[k] = kInfinity;
    robots.preferred_x[k] = v.x, robots.preferred_y[k] = v.y;
  }
}

void choose_externally(const World& world, RobotId robot, Vec2 goal, Simulation::Perception& seen) {
  const std::size_t slot = world.fleet.find(robot);
  if (!is_external(world.fleet.conduct[slot].method) || world.waits_to_start(slot)) return;
  BatchColumns alone;
  alone.clear();
  alone.add(robot, seen.robot, goal, seen.neighbors, seen.walls);
  std::vector<Vec2> velocities;
  choose(world, alone, velocities);
  if (velocities.front() != seen.robot.preferred_velocity) seen.robot.distance_to_goal = kInfinity;
  seen.robot.preferred_velocity = velocities.front();
  seen.guide = Guide::host;
}

}  // namespace avo::inline sim

namespace avo {

void MethodColumns::take(const MethodBatch& batch) {
  *this = {};
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Robot& robot = batch.robot[i];
    id.push_back(batch.id[i].value);
    position.push_back(robot.position), velocity.push_back(robot.velocity);
    preferred_velocity.push_back(robot.preferred_velocity);
    radius.push_back(robot.radius), max_speed.push_back(robot.max_speed);
    max_acceleration.push_back(robot.max_acceleration);
    max_braking.push_back(braking_limit(robot)), heading.push_back(robot.heading);
  }
  for (const Neighbor& neighbor : batch.neighbor) {
    neighbor_position.push_back(neighbor.position), neighbor_velocity.push_back(neighbor.velocity);
    neighbor_radius.push_back(neighbor.radius);
    neighbor_max_acceleration.push_back(shares(neighbor) ? neighbor.max_acceleration : 0.0);
    neighbor_behavior.push_back(static_cast<std::uint8_t>(neighbor.behavior));
  }
  for (const Wall& wall : batch.wall)
    wall_a.push_back(wall.a), wall_b.push_back(wall.b), wall_radius.push_back(wall.radius);
}

ExternalMethod by_acceleration(ExternalMethod method) {
  return [method = std::move(method)](const MethodBatch& batch, std::span<Vec2> velocities) {
    std::fill(velocities.begin(), velocities.end(), Vec2{});
    method(batch, velocities);
    for (std::size_t i = 0; i < batch.size(); ++i)
      velocities[i] = batch.robot[i].velocity + batch.time_step * velocities[i];
  };
}

}  // namespace avo
