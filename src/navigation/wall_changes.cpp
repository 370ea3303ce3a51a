// SPDX-License-Identifier: Apache-2.0
#include "navigation/wall_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace avo::inline navigation {
namespace {

constexpr std::size_t kMostChanged = 64;  // walls

bool are_equal(const Wall& a, const Wall& b) {
  return a.a == b.a && a.b == b.b && a.radius == b.radius;
}

}  // namespace

WallChanges::WallChanges(std::span<const Wall> old, std::span<const Wall> walls)
    : before(old), now(walls) {
  const std::size_t common = before.size() < now.size() ? before.size() : now.size();
  while (same_first < common && are_equal(before[same_first], now[same_first])) ++same_first;
  while (same_last < common - same_first &&
         are_equal(before[before.size() - 1 - same_last], now[now.size() - 1 - same_last]))
    ++same_last;
}

bool WallChanges::are_few() const {
  return removed().size() + added().size() <= kMostChanged;
}

std::optional<std::size_t> WallChanges::number_before(std::size_t wall) const {
  if (wall < same_first) return wall;
  if (wall + same_last >= now.size()) return wall + before.size() - now.size();
  return std::nullopt;
}

std::vector<Zone> WallChanges::around(double reach) const {
  std::vector<Zone> zones;
  for (const std::span<const Wall> changed : {removed(), added()}) {
    for (const Wall& wall : changed) {
      const Vec2 along = wall.b - wall.a;
      const double pieces = std::ceil(norm(along) / (2.0 * reach)) + 1.0;
      const double around = 0.5 * norm(along) / pieces + wall.radius + reach;
      for (double k = 0.5; k < pieces; k += 1.0)
        zones.push_back({wall.a + (k / pieces) * along, around});
    }
  }
  return zones;
}

bool is_in_one(std::span<const Zone> zones, Vec2 p, double margin) {
  return std::any_of(zones.begin(), zones.end(), [&](const Zone& zone) {
    return norm(p - zone.center) <= zone.reach + margin;
  });
}

// All routes of that length lie in an ellipse.
bool may_meet(std::span<const Zone> zones, Vec2 p, Vec2 q, double length) {
  const double apart = norm(q - p);
  const double half_width = 0.5 * std::sqrt(std::max(length * length - apart * apart, 0.0));
  return std::any_of(zones.begin(), zones.end(), [&](const Zone& zone) {
    const double aside = apart > 0.0 ? std::abs(cross(q - p, zone.center - p)) / apart : 0.0;
    const double by = norm(p - zone.center) + norm(q - zone.center);
    return aside <= half_width + zone.reach && by <= length + 2.0 * zone.reach;
  });
}

double least_route_into(std::span<const Zone> zones, Vec2 p, Vec2 q) {
  double least = std::numeric_limits<double>::infinity();
  for (const Zone& zone : zones)
    least = std::min(least, norm(p - zone.center) + norm(q - zone.center) - 2.0 * zone.reach);
  return least;
}

}  // namespace avo::inline navigation
