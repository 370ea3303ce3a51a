// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/steer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "certificate/wall_constraints.h"
#include "core/plane.h"
#include "planner/decision.h"
#include "planner/stages/disc_pairs.h"
#include "robots/model.h"
#include "walls/segment.h"

namespace avo::inline planner {
namespace {

// The distances that a maneuver keeps from walls and others, by nearness, in radii of the robot.
constexpr std::array kKeeps{0.01, 0.03, 0.05};
// of the robot's radius: a body that is nearer already may stay as near
constexpr double kTouching = 0.001;
constexpr double kNearlyAtRest = 0.1;  // of its radius: the stopping distance of a slow neighbor, m

using ManeuverObstacle = SteerMemory::ManeuverObstacle;

// m, beyond contact: the distance to the added obstacle, where it may block the robot. room: m, for
// the nearest disc. A drive in contact cannot turn, because its discs swell while it may turn:
// later places are never that near.
std::optional<double> add_obstacle(const Discs& discs, double room, const Segment& segment,
                                   double radius, std::vector<ManeuverObstacle>& obstacles) {
  double away = kInfinity;
  for (const Robot& disc : discs.all()) away = std::min(away, distance(disc.position, segment));
  const double own = discs.discs[0].radius, contact = own + radius;
  if (away > contact + room) return std::nullopt;
  const double nearest = away - kTouching * own;
  ManeuverObstacle& obstacle = obstacles.emplace_back();
  obstacle.segment = segment;
  for (std::size_t k = 0; k < kKeeps.size(); ++k)
    obstacle.keep[k] = std::min(contact + kKeeps[k] * own, nearest);
  if (!moves_along_heading(discs.discs[0].model))
    obstacle.keep.back() = contact + kKeeps.back() * own;
  return away - contact;
}

bool are_clear(const std::vector<ManeuverObstacle>& obstacles, Vec2 place, Nearness nearness) {
  return std::none_of(obstacles.begin(), obstacles.end(), [&](const ManeuverObstacle& o) {
    return distance(place, o.segment) < o.keep[static_cast<std::size_t>(nearness)];
  });
}

// The same for all discs of a footprint, with the robot at that place.
bool are_clear(const std::vector<ManeuverObstacle>& obstacles, const Footprint& footprint,
               Vec2 place, Vec2 heading, Nearness nearness) {
  if (!footprint) return are_clear(obstacles, place, nearness);
  for (int k = 0; k < footprint.discs; ++k)
    if (!are_clear(obstacles, place + footprint.ahead(k) * heading, nearness)) return false;
  return true;
}

// Adds walls; returns whether the robot could touch one of them soon.
bool add_walls(const Robot& robot, const Discs& discs, std::span<const Wall> walls,
               const StepLaw& law, double room, std::vector<ManeuverObstacle>& obstacles) {
  const double reach = wall_reach(robot.max_speed, robot.max_speed, ability_of(robot), law);
  bool is_beside = false;
  for (const Wall& wall : walls) {
    const auto away = add_obstacle(discs, room, {wall.a, wall.b},
                                   wall.radius + law.localization_error, obstacles);
    is_beside = is_beside || (away && *away <= reach);
  }
  return is_beside;
}

// A robot that cannot reverse stays for ever where it meets others face to face. These others block
// it as walls do, once they are slow.
void add_slow_neighbors(const Robot& robot, const Discs& discs, const Neighbors& neighbors,
                        double room, std::vector<ManeuverObstacle>& obstacles) {
  if (model_traits(robot.model).can_reverse) return;
  for (std::size_t k = 0; k < neighbors.count; ++k) {
    const Neighbor neighbor = neighbors[k];
    const double speed = norm(neighbor.velocity), time = 0.5 * speed / braking_limit(neighbor);
    if (speed * time > kNearlyAtRest * discs.discs[0].radius) continue;
    for (int l = 0; l < disc_count(neighbor); ++l) {
      const Neighbor disc = disc_of(neighbor, l);
      add_obstacle(discs, room, {disc.position, disc.position + time * disc.velocity}, disc.radius,
                   obstacles);
    }
  }
}

std::optional<Vec2> maneuver_of(const PlannerOptions& options, const StepLaw& law, Tile& tile,
                                std::size_t i, SteerMemory& memory) {
  const double room = model_traits(*tile.robots.model[i]).maneuver_room;
  if (room == 0.0) return std::nullopt;
  const Robot robot = tile.robots.robot(i);
  const Discs discs = discs_of(robot, law);
  const Footprint footprint = footprint_of(robot.model);
  std::vector<ManeuverObstacle>& obstacles = memory.obstacles;
  obstacles.clear();
  const bool is_beside = add_walls(robot, discs, tile.walls_of(i), law, room, obstacles);
  const bool has_walls = !obstacles.empty();
  add_slow_neighbors(robot, discs, tile.robots.neighbors[i], room, obstacles);
  if (obstacles.empty()) return std::nullopt;
  const auto wish = maneuver(
      robot, approach_of(options), is_beside || !has_walls,
      [&](Vec2 place, Vec2 heading, Nearness nearness) {
        return are_clear(obstacles, footprint, place, heading, nearness);
      },
      memory.maneuvers);
  tile.maneuvers[i] = wish && has_walls ? 1 : 0;
  return wish;
}

}  // namespace

void steer(const PlannerOptions& options, const StepLaw& law, Tile& tile, SteerMemory& memory) {
  RobotColumns& robots = tile.robots;
  tile.maneuvers.assign(robots.count, 0);
  for (std::size_t i = 0; i < robots.count; ++i) {
    if (robots.model[i] == nullptr) continue;
    std::optional<Vec2> wish;
    if (method_traits(options.method).has_rules) wish = maneuver_of(options, law, tile, i, memory);
    if (!wish) wish = steered(robots.robot(i), approach_of(options));
    robots.preferred_x[i] = wish->x, robots.preferred_y[i] = wish->y;
  }
}

}  // namespace avo::inline planner
