// SPDX-License-Identifier: Apache-2.0
// The line around a wall on which the center of a disc lies that touches the wall. It has two
// straight sides, and circles around the wall's ends.
#pragma once
#include <array>
#include <cmath>

#include "avo/wall.h"
#include "walls/segment.h"

namespace avo::inline navigation {

struct WallBoundary {
  Segment wall;                  // m
  double reach = 0.0;            // m, from the wall's middle line
  std::array<Segment, 2> sides;  // m; none of a disc
  bool is_disc = false;
};

inline WallBoundary boundary_around(const Wall& wall, double radius) {
  WallBoundary boundary{{wall.a, wall.b}, wall.radius + radius, {}, wall.a == wall.b};
  if (boundary.is_disc) return boundary;
  const Vec2 along = wall.b - wall.a;
  const Vec2 aside = (boundary.reach / norm(along)) * perpendicular(along);
  boundary.sides = {Segment{wall.a + aside, wall.b + aside},
                    Segment{wall.a - aside, wall.b - aside}};
  return boundary;
}

/// Calls visit(point) for the places where it changes from a side to a circle, and for the middle
/// of each circle.
template <typename Visit>
void visit_bends(const WallBoundary& boundary, const Visit& visit) {
  if (boundary.is_disc) {
    for (const Vec2 out : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}})
      visit(boundary.wall.a + boundary.reach * out);
    return;
  }
  for (const Segment& side : boundary.sides) visit(side.a), visit(side.b);
  const Vec2 along = boundary.wall.b - boundary.wall.a;
  const Vec2 out = (boundary.reach / norm(along)) * along;
  visit(boundary.wall.a - out), visit(boundary.wall.b + out);
}

/// Calls visit(point) for all points that may be the nearest one to the goal, without bends.
/// `towards`: the direction from the middle of a circle.
template <typename Visit>
void visit_feet(const WallBoundary& boundary, Vec2 goal, Vec2 towards, const Visit& visit) {
  for (const Vec2 center : {boundary.wall.a, boundary.wall.b}) {
    const Vec2 line = goal == center ? towards - center : goal - center;
    const double distance = norm(line);
    if (distance > 0.0) visit(center + (boundary.reach / distance) * line);
    if (boundary.is_disc) return;
  }
  for (const Segment& side : boundary.sides) visit(nearest_on(side, goal));
}

/// Calls visit(point) where two circles cross.
template <typename Visit>
void visit_crossings(Vec2 center, double radius, Vec2 other_center, double other_radius,
                     const Visit& visit) {
  const Vec2 line = other_center - center;
  const double distance_squared = norm_squared(line), distance = std::sqrt(distance_squared);
  if (!(distance > 0.0)) return;
  const double along =
      0.5 * (distance_squared + (radius - other_radius) * (radius + other_radius)) / distance;
  const double aside_squared = (radius - along) * (radius + along);
  if (!(aside_squared >= 0.0)) return;
  const Vec2 middle = center + (along / distance) * line;
  const Vec2 aside = (std::sqrt(aside_squared) / distance) * perpendicular(line);
  visit(middle + aside), visit(middle - aside);
}

/// Calls visit(point) where a circle crosses the line of a segment.
template <typename Visit>
void visit_crossings(Vec2 center, double radius, const Segment& line, const Visit& visit) {
  const Vec2 along = line.b - line.a;
  const double length = norm(along);
  const Vec2 unit = along / length;
  const Vec2 foot = line.a + dot(center - line.a, unit) * unit;
  const double away = norm(foot - center);
  const double half_squared = (radius - away) * (radius + away);
  if (!(half_squared >= 0.0)) return;
  const Vec2 half = std::sqrt(half_squared) * unit;
  visit(foot + half), visit(foot - half);
}

/// Calls visit(point) where the lines of two segments cross.
template <typename Visit>
void visit_crossings(const Segment& one, const Segment& other, const Visit& visit) {
  const Vec2 d = one.b - one.a, e = other.b - other.a;
  const double sine = cross(d, e);
  if (sine == 0.0) return;
  visit(one.a + (cross(other.a - one.a, e) / sine) * d);
}

/// Calls visit(point) for all places where two boundaries cross, and for others, which are nearer
/// to one of the walls or farther from it.
template <typename Visit>
void visit_crossings(const WallBoundary& one, const WallBoundary& other, const Visit& visit) {
  const auto circles_of = [](const WallBoundary& boundary, const auto& visit_circle) {
    visit_circle(boundary.wall.a);
    if (!boundary.is_disc) visit_circle(boundary.wall.b);
  };
  const auto sides_of = [](const WallBoundary& boundary, const auto& visit_side) {
    if (boundary.is_disc) return;
    for (const Segment& side : boundary.sides) visit_side(side);
  };
  circles_of(one, [&](Vec2 center) {
    circles_of(other, [&](Vec2 other_center) {
      visit_crossings(center, one.reach, other_center, other.reach, visit);
    });
    sides_of(other, [&](const Segment& side) { visit_crossings(center, one.reach, side, visit); });
  });
  sides_of(one, [&](const Segment& side) {
    circles_of(other, [&](Vec2 center) { visit_crossings(center, other.reach, side, visit); });
    sides_of(other, [&](const Segment& other_side) { visit_crossings(side, other_side, visit); });
  });
}

}  // namespace avo::inline navigation
