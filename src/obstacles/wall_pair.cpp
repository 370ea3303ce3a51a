// SPDX-License-Identifier: Apache-2.0
#include "obstacles/wall_pair.h"

#include <cmath>

#include "obstacles/constants.h"

namespace avo::inline obstacles {
namespace {

// Returns whether the ray, not only its line, runs through an inner point of the segment.
bool crosses(const WallPair& pair) {
  const Vec2 a = pair.from_a, b = pair.from_b, v = pair.velocity;
  const double side_a = cross(v, a), side_b = cross(v, b);
  if (!((side_a < 0.0 && side_b > 0.0) || (side_a > 0.0 && side_b < 0.0))) return false;
  const Vec2 from_crossing = a - (side_a / (side_a - side_b)) * (a - b);
  return dot(from_crossing, v) < 0.0;
}

}  // namespace

WallPair relative(const Robot& robot, const Wall& wall) {
  return {robot.position - wall.a, robot.position - wall.b, robot.velocity,
          robot.radius + wall.radius};
}

Vec2 away_from_wall(const WallPair& pair, Vec2 moved) {
  const Vec2 x = pair.from_a + moved, along = pair.from_a - pair.from_b;
  const double foot = dot(x, along), length_squared = norm_squared(along);
  if (!(foot > 0.0)) return x;
  if (!(foot < length_squared)) return pair.from_b + moved;
  return (cross(along, x) / length_squared) * perpendicular(along);
}

Vec2 nearest_pass(const WallPair& pair) {
  if (crosses(pair)) return {};
  const Vec2 v = pair.velocity;
  const bool moves = norm(v) > kSlowest;
  Vec2 nearest = away_from_wall(pair, {});
  for (const Vec2 from_end : ends_of(pair)) {
    if (!moves || !(dot(from_end, v) < 0.0)) continue;
    const Vec2 miss = (cross(v, from_end) / norm_squared(v)) * perpendicular(v);
    if (norm_squared(miss) < norm_squared(nearest)) nearest = miss;
  }
  return nearest;
}

Facing facing(const WallPair& pair) {
  const Vec2 along = pair.from_a - pair.from_b;
  const double length = norm(along), side = cross(along, pair.from_a) / length;
  const double sign = side < 0.0 ? -1.0 : 1.0;
  return {(sign / length) * perpendicular(along), sign * side};
}

Pair pair_in_contact(const WallPair& pair, Vec2 away) {
  if (norm(away) > kTiniest) return {away, pair.velocity, pair.radius};
  const Vec2 along = pair.from_a - pair.from_b, n = perpendicular(along) / norm(along);
  const double sign = dot(n, pair.velocity) < 0.0 ? -1.0 : 1.0;
  return {(sign * kContact * pair.radius) * n, pair.velocity, pair.radius};
}

}  // namespace avo::inline obstacles
