// SPDX-License-Identifier: Apache-2.0
// What a tile of robots knows of itself, and where each robot wants to go next: routes, passages,
// places at goals.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "core/plane.h"
#include "guidance/ties.h"
#include "robots/ahead.h"
#include "robots/model.h"
#include "sim/clocks.h"
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
  std::size_t all = 0;
  for (const std::uint32_t slot : slots) {
    const WallGrid& grid = world.statics.floors[world.floor_of(slot)].grid;
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
void follow_routes(const World& world, const Pace& pace, std::span<const Claims> claims,
                   std::span<const std::uint32_t> slots, Worker& worker) {
  const double time_step = pace.planner.options().time_step;
  RobotColumns& robots = worker.tile.robots;
  if (world.fleet.has_footprints) robots.lookahead.assign(slots.size(), kInfinity);
  worker.headings.clear();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Vec2 lost = worker.lost.empty() ? Vec2{} : worker.lost[k];
    const double nearest =
        nearest_of(worker.tile.robots.neighbors[k], world.fleet.position[slots[k]]);
    const std::size_t floor = world.floor_of(slots[k]);
    const Follower follower = follower_of(world, slots[k], lost, nearest);
    const Headings found = guide(world.routes[floor], claims[floor], follower, time_step,
                                 world.sensing_radius, *worker.travels[k], worker.legs);
    if (!world.shares_goal.empty()) worker.headings.push_back(found.by_route);
    worker.moving.goal_x[k] = found.heading.goal.x, worker.moving.goal_y[k] = found.heading.goal.y;
    worker.moving.preferred_speed[k] = found.heading.preferred_speed;
    if (!robots.lookahead.empty() && reach_of(follower.traits) > 0.0)
      robots.lookahead[k] = norm(found.heading.next - follower.place);
    if (worker.told != nullptr) *worker.told = found.heading.guide;
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
void aim_discs(const World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  MovingColumns& moving = worker.moving;
  const Fleet& fleet = world.fleet;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::uint32_t slot = slots[k];
    const Vec2 aim{moving.goal_x[k], moving.goal_y[k]};
    const Vec2 lost = worker.lost.empty() ? Vec2{} : worker.lost[k];
    Vec2 goal = disc_goal(fleet, slot, aim, world.end_of(slot)) - lost;
    if (shares_room(world, slot)) {
      const Heading heading = world.travels.empty()
                                  ? straight_to(fleet.goal[slot], fleet.traits[slot])
                                  : worker.headings[k];
      const Seeker seeker = seeker_of(world, slot, heading, lost);
      Occupied& occupied = look_at_goal(seeker, worker.tile.robots.neighbors[k], worker);
      const AtSharedGoal decided = at_shared_goal(seeker, occupied, world.routes_of(slot),
                                                  worker.tile.walls_of(k), *worker.tile.detour[k]);
      if (decided.heads_for) {
        goal = *decided.heads_for, moving.preferred_speed[k] = heading.preferred_speed;
        if (!worker.tile.robots.lookahead.empty()) worker.tile.robots.lookahead[k] = kInfinity;
        if (worker.told != nullptr) *worker.told = Guide::place;
      }
      *worker.has_stood[k] = decided.has_stood ? 1 : 0;
      if (decided.stops) worker.staying.push_back(slot);
    }
    moving.goal_x[k] = goal.x, moving.goal_y[k] = goal.y;
  }
}

// Robots that fly do not slow down at their goals, and circle after they have passed them.
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

// Returns whether a robot that is told to stop is so slow that it may do so in this step: its
// approach to the velocity 0 never ends.
bool stops_now(const RobotColumns& robots, std::size_t k, Vec2 told) {
  constexpr double kNearlyAtRest = 1e-3;  // of max_speed
  const double speed = norm(robots.velocity(k));
  return told == Vec2{} && robots.model[k] == nullptr && speed > 0.0 &&
         speed <= kNearlyAtRest * robots.max_speed[k];
}

// Robots with a preferred velocity of the host do not come to rest at a goal.
void take_told(const World& world, std::span<const std::uint32_t> slots, Worker& worker) {
  RobotColumns& robots = worker.tile.robots;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::optional<Vec2> v = world.steered(slots[k]);
    if (!v) continue;
    robots.preferred_x[k] = v->x, robots.preferred_y[k] = v->y;
    robots.distance_to_goal[k] =
        stops_now(robots, k, *v) ? 0.0 : std::numeric_limits<double>::infinity();
    if (worker.told != nullptr) *worker.told = Guide::host;
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

// Fills in what the robots know of themselves.
void fill_in(const Fleet& fleet, std::span<const std::uint32_t> slots, Worker& worker) {
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
    tile.detour[k]->goal_taken = false;
    tile.slot.push_back(slot);
  }
}

}  // namespace

void set_out(const World& world, const Pace& pace, std::span<const Claims> claims,
             std::span<const std::uint32_t> slots, Worker& worker) {
  const Fleet& fleet = world.fleet;
  RobotColumns& robots = worker.tile.robots;
  fill_in(fleet, slots, worker);
  if (method_traits(pace.planner.options().method).has_rules) break_ties(fleet, worker.tile);
  robots.model.assign(slots.size(), nullptr);
  for (std::size_t k = 0; k < slots.size() && !fleet.models.empty(); ++k) {
    robots.model[k] = fleet.own_model(slots[k]);
    robots.has_models = robots.has_models || robots.model[k] != nullptr;
  }
  if (robots.has_models) look_ahead(robots);
  lose_places(world, slots, worker);
  if (world.statics.has_walls) list_walls(world, slots, worker);
  if (!world.travels.empty()) follow_routes(world, pace, claims, slots, worker);
  if (robots.has_models || !world.shares_goal.empty() || !worker.lost.empty())
    aim_discs(world, slots, worker);
  choose_preferred(pace.response, worker.moving, robots);
  if (!fleet.flights.empty()) set_courses(fleet, slots, worker);
  if (world.steers_some()) take_told(world, slots, worker);
}

}  // namespace avo::inline sim
