// SPDX-License-Identifier: Apache-2.0
#include "support/sampled_half_plane.h"

#include <cmath>
#include <optional>
#include <vector>

#include "avo/velocity_obstacle.h"
#include "obstacles/constants.h"

namespace avo::test {
namespace {

// Directions in which the circle of reach is tested: its arcs inside the polygon belong to the
// hull.
constexpr int kCircleOctant = 8;

using Polygon = std::vector<Vec2>;

// Both sides and the arc of the last disc as one loop in w, from the far left to the far right.
Polygon sampled_polygon(const Obstacle& obstacle, int samples) {
  const Boundary sides = boundary(obstacle, samples);
  Polygon loop(sides.left.rbegin(), sides.left.rend());
  if (!sides.cap.empty()) loop.insert(loop.end(), sides.cap.begin() + 1, sides.cap.end() - 1);
  loop.insert(loop.end(), sides.right.begin(), sides.right.end());
  for (Vec2& point : loop) point = change(obstacle, point);
  return loop;
}

// Turns of the loop around the point; not zero inside.
int winding(const Polygon& loop, Vec2 point) {
  int turns = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec2 a = loop[k] - point, b = loop[(k + 1) % loop.size()] - point;
    if (a.y <= 0.0 && b.y > 0.0 && cross(a, b) > 0.0) ++turns;
    if (a.y > 0.0 && b.y <= 0.0 && cross(a, b) < 0.0) --turns;
  }
  return turns;
}

// Where the segment from a to b crosses the circle |w| = reach.
void append_crossings(Vec2 a, Vec2 b, double reach, Polygon& points) {
  const Vec2 d = b - a;
  const double length = norm(d);
  if (!(length > 0.0)) return;
  const Vec2 u = d / length;
  const double foot = -dot(a, u);
  const double miss = std::abs(cross(a, u));
  if (!(miss < reach)) return;
  const double half = std::sqrt((reach - miss) * (reach + miss));
  for (const double along : {foot - half, foot + half}) {
    if (along > 0.0 && along < length) points.push_back(a + along * u);
  }
}

// Unit vectors all around, at equal steps along the sides of a square about p's direction.
std::vector<Vec2> compass(Vec2 p) {
  std::vector<Vec2> directions;
  Vec2 axis = p / norm(p);
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (int k = -kCircleOctant; k < kCircleOctant; ++k) {
      const Vec2 d = axis + (static_cast<double>(k) / kCircleOctant) * perpendicular(axis);
      directions.push_back(d / norm(d));
    }
    axis = perpendicular(axis);
  }
  return directions;
}

// The first sampled disc that lies inside the one before, as a polygon; empty if there is none. A
// pair that approaches fast has such discs: they have no boundary of their own, and contain the
// next one.
Polygon nested_disc(const Obstacle& obstacle, int samples) {
  const Pair& pair = obstacle.pair;
  Polygon polygon;
  for (int k = 1; k <= samples && polygon.empty(); ++k) {
    const double t = obstacle.time_horizon * k / samples;
    if (norm(pair.position + obstacle.response.lag(t) * pair.velocity) >= pair.radius) continue;
    const Disc at_t = disc(obstacle, t);
    for (const Vec2 direction : compass(pair.position)) {
      polygon.push_back(change(obstacle, at_t.center + at_t.radius * direction));
    }
  }
  return polygon;
}

// Appends the extreme points of D(0, reach) ∩ polygon; false if the polygon contains all of the
// disc.
bool clip(const Polygon& polygon, double reach, Vec2 p, Polygon& points) {
  const std::size_t before = points.size();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    if (norm(polygon[k]) <= reach) points.push_back(polygon[k]);
    append_crossings(polygon[k], polygon[(k + 1) % polygon.size()], reach, points);
  }
  if (points.size() == before) return polygon.empty() || winding(polygon, {}) == 0;
  for (const Vec2 direction : compass(p)) {
    if (winding(polygon, reach * direction) != 0) points.push_back(reach * direction);
  }
  return true;
}

// Corners of the convex hull, counter-clockwise from the point farthest from 0 (gift wrapping).
// All its tests are even in the points, so that negated points give the negated hull.
Polygon convex_hull(const Polygon& points) {
  std::size_t start = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (norm_squared(points[k]) > norm_squared(points[start])) start = k;
  }
  Polygon hull;
  std::size_t at = start;
  do {
    hull.push_back(points[at]);
    std::size_t next = at;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec2 to = points[k] - points[at];
      if (to == Vec2{}) continue;
      const Vec2 ahead = points[next] - points[at];
      const double side = cross(ahead, to);
      if (next == at || side < 0.0 ||
          (side == 0.0 && norm_squared(to) > norm_squared(ahead) && dot(to, ahead) > 0.0)) {
        next = k;
      }
    }
    at = next;
  } while (!(points[at] == hull.front()) && hull.size() < points.size());
  return hull;
}

// The direction of least support among the normals of the hull's edges and the directions of its
// corners, Eq. (16).
HalfPlane least_support(const Polygon& hull, double reach, Vec2 p) {
  std::optional<HalfPlane> best;
  const auto offer = [&](Vec2 normal) {
    const double length = norm(normal);
    if (!(length > 0.0)) return;
    HalfPlane plane{normal / length, dot(normal, hull.front()) / length};
    for (const Vec2 corner : hull) {
      plane.offset = std::fmax(plane.offset, dot(plane.normal, corner));
    }
    const double gain = best ? best->offset - plane.offset : 1.0;
    const bool tied = best && std::abs(gain) <= kEqualSupports * reach;
    const Vec2 left = perpendicular(p);
    if (tied ? dot(plane.normal, left) > dot(best->normal, left) : gain > 0.0) best = plane;
  };
  for (std::size_t k = 0; k < hull.size(); ++k) {
    offer(-hull[k]);
    offer(-perpendicular(hull[(k + 1) % hull.size()] - hull[k]));
  }
  return best.value_or(HalfPlane{p / norm(p), 0.0});
}

}  // namespace

RelativeHalfPlane sampled_half_plane(const Pair& pair, double reach, const Horizon& horizon,
                                     int samples) {
  const double distance = norm(pair.position);
  if (distance < pair.radius || !(distance > 0.0)) return half_plane(pair, reach, horizon);
  const Obstacle obstacle{pair, Response::proportional(horizon.control_time()), horizon.end().time};
  const Vec2 p = pair.position;
  Polygon points;
  for (const Polygon& part : {sampled_polygon(obstacle, samples), nested_disc(obstacle, samples)}) {
    // its nearest side says how far beyond reach safety lies
    if (!clip(part, reach, p, points)) {
      return {PairState::constrained, least_support(convex_hull(part), reach, p)};
    }
  }
  if (points.empty()) return {};
  return {PairState::constrained, least_support(convex_hull(points), reach, p)};
}

}  // namespace avo::test
