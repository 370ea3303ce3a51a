// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/behind_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "certificate/wall_constraints.h"
#include "core/plane.h"
#include "planner/decision.h"
#include "robots/footprint.h"
#include "walls/segment.h"

namespace avo::inline planner {
namespace {

constexpr double kRounding = 0x1p-40;  // of coordinates and lengths, more than all losses together

// m, from its center, the range of everything that it can touch.
double reach_of(const Robot& robot, const StepLaw& law) {
  return robot.radius + wall_reach(norm(robot.velocity), robot.max_speed, ability_of(robot), law);
}
double reach_of(const Neighbor& neighbor, const StepLaw& law) {
  return neighbor.radius +
         wall_reach(norm(neighbor.velocity), kInfinity, ability_of(neighbor), law);
}

double distance_to(const Wall& wall, Vec2 p) {
  return distance(p, {wall.a, wall.b});
}

// Returns whether the straight line from p to q crosses the wall's middle line.
bool crosses(Vec2 p, Vec2 q, const Wall& wall) {
  const Vec2 line = q - p, along = wall.b - wall.a;
  const double a = cross(line, wall.a - p), b = cross(line, wall.b - p);
  const double from = cross(along, p - wall.a), to = cross(along, q - wall.a);
  return (a < 0.0) != (b < 0.0) && (from < 0.0) != (to < 0.0);
}

// m, from p to q around the nearer end.
double length_round(Vec2 p, Vec2 q, const Wall& wall) {
  return std::min(norm(p - wall.a) + norm(wall.a - q), norm(p - wall.b) + norm(wall.b - q));
}

// Returns whether the path that it needs to stop keeps clear of the wall.
bool keeps_clear(Vec2 p, Vec2 velocity, double max_braking, double radius, const Wall& wall,
                 const StepLaw& law) {
  const Vec2 to_stop = stopping_vector(velocity, braking_decrement(max_braking, law), law);
  return distance(Segment{p, p + to_stop}, {wall.a, wall.b}) >= radius + wall.radius;
}

// The walls that may hide a neighbor from a robot. If there are more walls, the others hide none.
struct HidingWalls {
  static constexpr std::size_t kMost = 32;
  std::array<const Wall*, kMost> walls;
  std::size_t count = 0;
  double reach;  // m, of the robot

  HidingWalls(const Robot& robot, std::span<const Wall> all, const StepLaw& law)
      : reach(reach_of(robot, law)) {
    // it does not brake, or it is no disc
    if (!can_rest(robot.model) || has_footprint(robot.model)) return;
    for (const Wall& wall : all) {
      if (count == kMost) break;
      if (distance_to(wall, robot.position) > reach + wall.radius) continue;
      if (keeps_clear(robot.position, robot.velocity, braking_limit(robot), robot.radius, wall,
                      law))
        walls[count++] = &wall;
    }
  }

  bool hide(Vec2 p, const Neighbor& neighbor, const StepLaw& law) const {
    if (neighbor.behavior != Behavior::decides || has_errors_of_its_own(neighbor) ||
        neighbor.loiter || neighbor.footprint)
      return false;
    const Vec2 q = neighbor.position;
    return std::any_of(walls.data(), walls.data() + count, [&](const Wall* wall) {
      if (!crosses(p, q, *wall)) return false;
      if (!keeps_clear(q, neighbor.velocity, braking_limit(neighbor), neighbor.radius, *wall, law))
        return false;
      const double round = length_round(p, q, *wall);
      const double lost = std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y) + round;
      return round > reach + reach_of(neighbor, law) + kRounding * lost;
    });
  }
};

// Returns whether robots are where they seem to be, also among the walls.
bool knows_places(const StepLaw& law) {
  return law.is_exact() && law.localization_error == 0.0;
}

}  // namespace

void leave_out_hidden(const PlannerOptions& options, const StepLaw& law, Tile& tile) {
  if (options.certificate == Certificate::none || tile.walls.empty() || !knows_places(law)) return;
  NeighborColumns& columns = tile.neighbors;
  for (std::size_t i = 0; i < tile.robots.count; ++i) {
    const std::span<const Wall> walls = tile.walls_of(i);
    if (walls.empty()) continue;
    const Robot robot = tile.robots.robot(i);
    const HidingWalls hiding(robot, walls, law);
    if (hiding.count == 0) continue;
    Neighbors& neighbors = tile.robots.neighbors[i];
    const std::size_t end = neighbors.first + neighbors.count;
    const std::size_t nearest = planned_with(options, neighbors.count);
    std::size_t kept = neighbors.first;
    for (std::size_t k = neighbors.first; k < end; ++k) {
      if (hiding.hide(robot.position, columns[k], law)) {
        if (k - neighbors.first < nearest) ++neighbors.hidden;
        continue;
      }
      if (kept != k) columns.replace(kept, k);
      ++kept;
    }
    neighbors.count = kept - neighbors.first;
  }
}

bool is_hidden(const Robot& robot, const Neighbor& neighbor, std::span<const Wall> walls,
               const StepLaw& law) {
  return knows_places(law) && HidingWalls(robot, walls, law).hide(robot.position, neighbor, law);
}

bool is_beside(const Robot& robot, std::span<const Wall> walls, const StepLaw& law) {
  const double reach =
      robot.radius + wall_reach(robot.max_speed, robot.max_speed, ability_of(robot), law);
  return std::any_of(walls.begin(), walls.end(), [&](const Wall& wall) {
    return distance_to(wall, robot.position) <= reach + wall.radius;
  });
}

}  // namespace avo::inline planner
