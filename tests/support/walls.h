// SPDX-License-Identifier: Apache-2.0
// Worlds of walls for tests, and the distance between a moving robot and a wall. It is computed
// from the robot's true motion, and shares nothing with the library's distances.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "avo/wall.h"
#include "support/certificates.h"

namespace avo::test {

/// Returns m, from a point to a wall's surface.
inline double gap_to(Vec2 p, const Wall& wall) {
  const long double dx = static_cast<long double>(wall.b.x) - wall.a.x;
  const long double dy = static_cast<long double>(wall.b.y) - wall.a.y;
  const long double px = static_cast<long double>(p.x) - wall.a.x;
  const long double py = static_cast<long double>(p.y) - wall.a.y;
  const long double squared = dx * dx + dy * dy;
  const long double part =
      squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0L, 1.0L) : 0.0L;
  const long double x = px - part * dx, y = py - part * dy;
  return static_cast<double>(std::sqrt(x * x + y * y)) - wall.radius;
}

/// Returns the least gap within one step, m. It is exact for held motion: the distance to each end
/// and to the line has its extrema at roots of a cubic and of a line. For other motion it is
/// sampled and refined.
inline double least_gap(const TrueStep& step, const Wall& wall, const PlannerOptions& options) {
  const double h = options.time_step;
  const auto gap = [&](double t) { return gap_to(step.at(t, options), wall); };
  double least = std::min(gap(0.0), gap(h));
  if (options.motion == Motion::held) {
    const Vec2 v = step.velocity, c = (step.next_velocity - v) / h, d = wall.b - wall.a;
    for (const Vec2 end : {wall.a, wall.b}) {
      for (const double t : cubic_roots(distance_slope(step.position - end, v, c), h))
        least = std::min(least, gap(t));
    }
    const std::array<double, 4> side{cross(d, step.position - wall.a), cross(d, v),
                                     0.5 * cross(d, c), 0.0};
    for (const double t : cubic_roots(side, h)) least = std::min(least, gap(t));
    for (const double t : cubic_roots({side[1], 2.0 * side[2], 0.0, 0.0}, h))
      least = std::min(least, gap(t));
    return least;
  }
  return std::min(least, refined_least(gap, h, 16, 30));
}

inline double gap_to_all(Vec2 p, const std::vector<Wall>& walls) {
  double least = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) least = std::min(least, gap_to(p, wall));
  return least;
}

inline double least_gap(const TrueStep& step, const std::vector<Wall>& walls,
                        const PlannerOptions& options) {
  const double way = options.time_step * std::max(norm(step.velocity), norm(step.next_velocity));
  double least = gap_to_all(step.position, walls);
  for (const Wall& wall : walls) {
    if (gap_to(step.position, wall) - way < least)
      least = std::min(least, least_gap(step, wall, options));
  }
  return least;
}

inline Vec2 in_square(Random& random, double side) {
  const double x = random.uniform(0.0, side);
  return {x, random.uniform(0.0, side)};
}

/// Returns one piece per 4 m² of a square: segments of 0.3 to 3 m, discs, concave corners, and
/// gates. A gate is between two collinear segments, and is 1e-6 m wider than a disc of the radius.
inline std::vector<Wall> random_walls(Random& random, double side, double radius) {
  std::vector<Wall> walls;
  const int count = static_cast<int>(0.25 * side * side);
  while (static_cast<int>(walls.size()) < count) {
    const Vec2 a = in_square(random, side);
    const Vec2 along = random.uniform(0.3, 3.0) * random.direction();
    const int kind = random.below(8);
    if (kind == 0) {
      walls.push_back({a, a, random.uniform(0.0, 0.6)});
    } else if (kind == 1) {
      const double angle = random.uniform(0.2, 2.0);
      const Vec2 other{std::cos(angle) * along.x - std::sin(angle) * along.y,
                       std::sin(angle) * along.x + std::cos(angle) * along.y};
      walls.push_back({a + along, a}), walls.push_back({a, a + other});
    } else if (kind == 2) {
      const Vec2 unit = along / norm(along);
      const double wide = 2.0 * radius + 1e-6;
      walls.push_back({a - along, a}), walls.push_back({a + wide * unit, a + wide * unit + along});
    } else {
      walls.push_back({a, a + along, random.below(4) == 0 ? random.uniform(0.0, 0.3) : 0.0});
    }
  }
  return walls;
}

/// Returns a place in the square, at least `room` m from all walls; far outside if there is no such
/// place.
inline Vec2 free_place(Random& random, const std::vector<Wall>& walls, double side, double room) {
  for (int k = 0; k < 10000; ++k) {
    const Vec2 p = in_square(random, side);
    if (gap_to_all(p, walls) >= room) return p;
  }
  return {-10.0 * side, -10.0 * side};
}

}  // namespace avo::test
