// SPDX-License-Identifier: Apache-2.0
#include "figures/hull.h"

#include <algorithm>
#include <cstddef>

namespace avo::figures {

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  const auto before = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  const auto turn = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  // the lower chain from left to right, then the upper one in reverse
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t first = hull.size();
    for (const Vec2 point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace avo::figures
