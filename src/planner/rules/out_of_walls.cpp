// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/out_of_walls.h"

#include <algorithm>
#include <numbers>

#include "core/elementary.h"
#include "planner/stages/demands.h"
#include "walls/segment.h"

namespace avo::inline planner {
namespace {

constexpr int kTries = 64;  // number of walls that a place is moved out of, one after the other
// The distance that a place keeps from walls, in radii: the largest one for which there is room.
constexpr double kClear[] = {0.02, 0.002, 0.0002};

// A wall that reaches into a disc.
struct Reaching {
  double depth = 0.0;  // m; 0: there is none
  Vec2 out;            // unit, or 0
};

// Unit, or 0: the direction away from a wall; where the place is on its segment, it is towards the
// side of the wish.
Vec2 away_from(const Wall& wall, Vec2 place, Vec2 wish) {
  const Vec2 away = place - nearest_on({wall.a, wall.b}, place),
             left = perpendicular(wall.b - wall.a);
  Vec2 out = away;
  if (out == Vec2{}) out = dot(left, wish) < 0.0 ? -left : left;
  if (out == Vec2{}) out = wish;
  if (out == Vec2{}) out = {1.0, 0.0};
  return out / norm(out);
}

Reaching deepest(const Robot& robot, std::span<const Wall> walls, Vec2 place, double radius) {
  const Wall* nearest = nullptr;
  double depth = 0.0;
  for (const Wall& wall : walls) {
    const double within = radius + wall.radius - distance(place, {wall.a, wall.b});
    if (within > depth) depth = within, nearest = &wall;
  }
  if (nearest == nullptr) return {};
  return {depth, away_from(*nearest, place, robot.preferred_velocity)};
}

bool is_straight_ahead(const Robot& robot, std::span<const Wall> walls, Vec2 place) {
  return std::none_of(walls.begin(), walls.end(), [&](const Wall& wall) {
    return distance(robot.position, {wall.a, wall.b}) > 0.0 &&
           !(distance({robot.position, place}, {wall.a, wall.b}) > 0.0);
  });
}

// Where no place is found: the direction out of all walls at once, weighted by depth.
Vec2 all_out(const Robot& robot, std::span<const Wall> walls) {
  Vec2 sum{};
  for (const Wall& wall : walls) {
    const double depth = robot.radius + wall.radius - distance(robot.position, {wall.a, wall.b});
    if (depth > 0.0) sum = sum + depth * away_from(wall, robot.position, robot.preferred_velocity);
  }
  return sum;
}

// The place after moving out of one wall after the other, the deepest first.
std::optional<Vec2> moved_out(const Robot& robot, std::span<const Wall> walls, Vec2 place,
                              double clear) {
  for (int k = 0; k < kTries; ++k) {
    const Reaching wall = deepest(robot, walls, place, (1.0 + 0.5 * clear) * robot.radius);
    if (!(wall.depth > 0.0))
      return is_straight_ahead(robot, walls, place) ? std::optional(place) : std::nullopt;
    place = place + (wall.depth + 0.5 * clear * robot.radius) * wall.out;
  }
  return std::nullopt;
}

// Where walls on both sides leave no room, a place may be ahead or behind: the nearest place that
// is found from the places around.
std::optional<Vec2> place_around(const Robot& robot, std::span<const Wall> walls) {
  constexpr int kDirections = 12;
  constexpr double kRings[] = {1.0, 2.0, 3.0};  // radii
  std::optional<Vec2> nearest;
  for (const double ring : kRings) {
    for (int k = 0; k < kDirections; ++k) {
      const Vec2 move =
          (ring * robot.radius) * elementary::direction(2.0 * std::numbers::pi * k / kDirections);
      const auto place = moved_out(robot, walls, robot.position + move, kClear[1]);
      if (place && (!nearest || norm_squared(*place - robot.position) <
                                    norm_squared(*nearest - robot.position)))
        nearest = place;
    }
  }
  return nearest;
}

}  // namespace

std::optional<Vec2> place_outside(const Robot& robot, std::span<const Wall> walls) {
  for (const double clear : kClear) {
    const auto place = moved_out(robot, walls, robot.position, clear);
    if (place) return place;
  }
  return place_around(robot, walls);
}

Vec2 velocity_out(const Robot& robot, std::span<const Wall> walls, const StepLaw& law) {
  if (!(deepest(robot, walls, robot.position, robot.radius).depth > 0.0)) return {};
  const std::optional<Vec2> place = place_outside(robot, walls);
  const Vec2 move = place ? *place - robot.position : all_out(robot, walls);
  const double length = norm(move);
  if (!(length > 1e-9 * robot.radius)) return {};
  return (std::min(speed_before(length, planned_braking(robot), law), robot.max_speed) / length) *
         move;
}

}  // namespace avo::inline planner
