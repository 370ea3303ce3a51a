// SPDX-License-Identifier: Apache-2.0
#include "navigation/clearance_grid.h"

#include <algorithm>

#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

// m, of each wall, from its middle line.
std::vector<double> reach_of(std::span<const Wall> walls, double beyond) {
  std::vector<double> reach;
  reach.reserve(walls.size());
  for (const Wall& wall : walls) reach.push_back(beyond + wall.radius);
  return reach;
}

double distance_squared(Vec2 p, const Segment& segment) {
  return norm_squared(p - nearest_on(segment, p));
}

// Returns whether the segment comes nearer than `limit` to the wall's middle line.
bool comes_nearer(const Segment& path, const Wall& wall, double limit) {
  const auto apart = [limit](double a, double b, double c, double d) {
    return std::min(a, b) - std::max(c, d) >= limit || std::min(c, d) - std::max(a, b) >= limit;
  };
  if (apart(path.a.x, path.b.x, wall.a.x, wall.b.x)) return false;
  if (apart(path.a.y, path.b.y, wall.a.y, wall.b.y)) return false;
  // both ends are beyond the limit on one side of the segment's line
  const Vec2 d = path.b - path.a, e = wall.b - wall.a;
  const double one = cross(d, wall.a - path.a), other = cross(d, wall.b - path.a);
  const double limit_squared = limit * limit;
  const double aside = limit_squared * norm_squared(d) * (1.0 + kLengthRounding);
  if (one * other > 0.0 && one * one > aside && other * other > aside) return false;
  const Segment line{wall.a, wall.b};
  const auto differ = [](double s, double t) { return (s < 0.0) != (t < 0.0); };
  if (differ(one, other) && differ(cross(e, path.a - line.a), cross(e, path.b - line.a)))
    return true;
  if (distance_squared(wall.a, path) < limit_squared) return true;
  if (distance_squared(wall.b, path) < limit_squared) return true;
  if (distance_squared(path.a, line) < limit_squared) return true;
  return distance_squared(path.b, line) < limit_squared;
}

}  // namespace

double widest_of(std::span<const Wall> walls) {
  double widest = 0.0;
  for (const Wall& wall : walls) widest = std::max(widest, wall.radius);
  return widest;
}

bool blocks(const Wall& wall, Vec2 p, Vec2 q, double room) {
  return comes_nearer({p, q}, wall, room + wall.radius);
}

ClearanceGrid::ClearanceGrid(std::span<const Wall> walls, double reach)
    : SegmentGrid(walls, reach_of(walls, reach), usual_cells(walls.size(), reach)), reach_(reach) {}

double ClearanceGrid::clearance(Vec2 p) const {
  double least = reach_;
  all_near(p, p, [&](std::size_t k) {
    const Wall& wall = walls()[k];
    least = std::min(least, distance(p, {wall.a, wall.b}) - wall.radius);
    return true;
  });
  return least;
}

bool ClearanceGrid::has_room(Vec2 p, double room) const {
  return all_near(p, p, [&](std::size_t k) {
    return distance(p, {walls()[k].a, walls()[k].b}) - walls()[k].radius >= room;
  });
}

bool ClearanceGrid::is_clear(Vec2 p, Vec2 q, double room) const {
  return all_near(p, q, [&](std::size_t k) { return !blocks(walls()[k], p, q, room); });
}

const Wall* ClearanceGrid::blocker(Vec2 p, Vec2 q, double room) const {
  const Wall* wall = nullptr;
  all_near(p, q, [&](std::size_t k) {
    if (blocks(walls()[k], p, q, room)) wall = &walls()[k];
    return wall == nullptr;
  });
  return wall;
}

}  // namespace avo::inline navigation
