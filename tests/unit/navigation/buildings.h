// SPDX-License-Identifier: Apache-2.0
// The buildings have walls with narrow lanes between them, and the same walls given otherwise.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "avo/wall.h"
#include "support/generators.h"

namespace avo::test {

/// From each point to the next one, and back to the first.
inline std::vector<Wall> ring(const std::vector<Vec2>& points) {
  std::vector<Wall> walls;
  for (std::size_t k = 0; k < points.size(); ++k)
    walls.push_back({points[k], points[(k + 1) % points.size()], 0.0});
  return walls;
}

/// Two rooms of 16 x 16 m with a door between them at x = 0.
inline std::vector<Wall> doorway(double width) {
  std::vector<Wall> walls = ring({{-16, -8}, {16, -8}, {16, 8}, {-16, 8}});
  walls.push_back({{0, -8}, {0, -0.5 * width}, 0.0});
  walls.push_back({{0, 0.5 * width}, {0, 8}, 0.0});
  return walls;
}

/// Two rooms of 14 x 16 m with a corridor from x = -5 to x = 5 between them.
inline std::vector<Wall> corridor(double width) {
  const double low = -0.5 * width, high = 0.5 * width;
  return ring({{-19, -8},
               {-5, -8},
               {-5, low},
               {5, low},
               {5, -8},
               {19, -8},
               {19, 8},
               {5, 8},
               {5, high},
               {-5, high},
               {-5, 8},
               {-19, 8}});
}

/// Ten rooms of 6 x 6 m on both sides of a corridor of 30 x 3 m, with doors of 1.6 m.
inline std::vector<Wall> office() {
  std::vector<Wall> walls = ring({{0, -7.5}, {30, -7.5}, {30, 7.5}, {0, 7.5}});
  for (const double side : {-1.0, 1.0}) {
    const double y = 1.5 * side;
    double from = 0.0;
    for (double door = 3.0; door < 30.0; door += 6.0) {
      walls.push_back({{from, y}, {door - 0.8, y}, 0.0});
      from = door + 0.8;
      if (door < 27.0) walls.push_back({{door + 3.0, y}, {door + 3.0, 5.0 * y}, 0.0});
    }
    walls.push_back({{from, y}, {30, y}, 0.0});
  }
  return walls;
}

/// The same set of places: in pieces that touch or overlap, some of them twice, in any order and
/// direction.
inline std::vector<Wall> in_pieces(const std::vector<Wall>& walls, Random& random) {
  std::vector<Wall> pieces;
  for (const Wall& wall : walls) {
    const int count = 1 + random.below(4);
    const auto at = [&](double part) {
      return part >= count ? wall.b : wall.a + (part / count) * (wall.b - wall.a);
    };
    for (int k = 0; k < count; ++k) {
      const double overlap = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.5);
      const Vec2 a = at(k), b = at(k + 1 + overlap);
      pieces.push_back(random.below(2) == 0 ? Wall{a, b, wall.radius} : Wall{b, a, wall.radius});
      if (random.below(5) == 0) pieces.push_back({a, b, wall.radius});
    }
  }
  for (std::size_t k = pieces.size(); k > 1; --k)
    std::swap(pieces[k - 1], pieces[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
  return pieces;
}

}  // namespace avo::test
