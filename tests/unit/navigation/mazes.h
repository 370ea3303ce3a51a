// SPDX-License-Identifier: Apache-2.0
// The functions make worlds to find routes in.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "avo/wall.h"
#include "support/generators.h"
#include "walls/segment.h"

namespace avo::test {

/// m, that a disc has from `p` to `q` between walls.
inline double room_of(const std::vector<Wall>& walls, Vec2 p, Vec2 q) {
  double least = 1e9;
  for (const Wall& wall : walls)
    least = std::min(least, distance({p, q}, {wall.a, wall.b}) - wall.radius);
  return least;
}

inline Vec2 turned(Vec2 p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y,
          std::sin(angle) * p.x + std::cos(angle) * p.y};
}

/// Walls of `count` random pieces in a square, some of them joined, some thick.
inline std::vector<Wall> random_walls(int count, double extent, std::uint64_t seed) {
  Random random(seed);
  const auto point = [&] { return Vec2{random.uniform(0.0, extent), random.uniform(0.0, extent)}; };
  std::vector<Wall> walls;
  for (int k = 0; k < count; ++k) {
    const Vec2 a = k % 3 == 0 && k > 0 ? walls.back().b : point();
    const Vec2 toward = point() - a;
    const Vec2 b = a + (random.uniform(0.5, 4.0) / std::max(norm(toward), 1e-3)) * toward;
    walls.push_back({a, b, k % 5 == 0 ? 0.1 : 0.0});
  }
  return walls;
}

/// The maze has side x side cells, and exactly one route reaches each place. The walls are loose
/// pieces, and each piece is a side of a cell. The pieces are in no order and in both directions.
inline std::vector<Wall> maze(int side, double cell, std::uint64_t seed) {
  Random random(seed);
  const auto cells = static_cast<std::size_t>(side);
  std::vector<char> is_known(cells * cells, 0);
  // walls on the right of and above each cell
  std::vector<char> right(cells * cells, 1), above(cells * cells, 1);
  std::vector<std::size_t> trail{0};
  is_known[0] = 1;
  while (!trail.empty()) {
    const std::size_t here = trail.back(), x = here % cells, y = here / cells;
    std::vector<int> ways;
    if (x + 1 < cells && is_known[here + 1] == 0) ways.push_back(0);
    if (x > 0 && is_known[here - 1] == 0) ways.push_back(1);
    if (y + 1 < cells && is_known[here + cells] == 0) ways.push_back(2);
    if (y > 0 && is_known[here - cells] == 0) ways.push_back(3);
    if (ways.empty()) {
      trail.pop_back();
      continue;
    }
    const auto pick =
        static_cast<std::size_t>(random.uniform(0.0, 0.999999) * static_cast<double>(ways.size()));
    const int way = ways[pick];
    const std::size_t there = way == 0   ? here + 1
                              : way == 1 ? here - 1
                              : way == 2 ? here + cells
                                         : here - cells;
    if (way < 2) right[std::min(here, there)] = 0;
    if (way >= 2) above[std::min(here, there)] = 0;
    is_known[there] = 1;
    trail.push_back(there);
  }
  std::vector<Wall> walls;
  const auto add = [&](double ax, double ay, double bx, double by) {
    const Vec2 a{ax * cell, ay * cell}, b{bx * cell, by * cell};
    const bool turned = random.uniform(0.0, 1.0) < 0.5;
    walls.push_back(turned ? Wall{b, a, 0.0} : Wall{a, b, 0.0});
  };
  for (std::size_t k = 0; k < cells * cells; ++k) {
    const auto x = static_cast<double>(k % cells), y = static_cast<double>(k / cells);
    if (right[k] != 0) add(x + 1, y, x + 1, y + 1);
    if (above[k] != 0) add(x, y + 1, x + 1, y + 1);
    if (k < cells) add(x, 0, x + 1, 0);
    if (k % cells == 0) add(0, y, 0, y + 1);
  }
  for (std::size_t k = walls.size(); k > 1; --k) {
    const auto other =
        static_cast<std::size_t>(random.uniform(0.0, 0.999999) * static_cast<double>(k));
    std::swap(walls[k - 1], walls[other]);
  }
  return walls;
}

/// The contours of a square map of side x side cells of 1 m, of which that share is blocked at
/// random.
inline std::vector<Wall> noise_map(int side, double share, std::uint64_t seed) {
  Random random(seed);
  const auto cells = static_cast<std::size_t>(side);
  std::vector<char> blocked(cells * cells);
  for (char& cell : blocked) cell = random.uniform(0.0, 1.0) < share ? 1 : 0;
  const auto is_blocked = [&](int x, int y) {
    const bool is_outside = x < 0 || y < 0 || x >= side || y >= side;
    return !is_outside &&
           blocked[static_cast<std::size_t>(y) * cells + static_cast<std::size_t>(x)] != 0;
  };
  std::vector<Wall> walls;
  for (int line = 0; line <= side; ++line) {
    const auto at = static_cast<double>(line);
    for (int k = 0; k < side; ++k) {
      const auto from = static_cast<double>(k);
      if (is_blocked(k, line) != is_blocked(k, line - 1))
        walls.push_back({{from, at}, {from + 1.0, at}, 0.0});
      if (is_blocked(line, k) != is_blocked(line - 1, k))
        walls.push_back({{at, from}, {at, from + 1.0}, 0.0});
    }
  }
  return walls;
}

/// Two rooms of 10 x 10 m with a door of that width between them.
inline std::vector<Wall> two_rooms(double door) {
  const double low = 5.0 - 0.5 * door, high = 5.0 + 0.5 * door;
  return {{{0, 0}, {20, 0}, 0}, {{20, 10}, {20, 0}, 0},  {{0, 10}, {20, 10}, 0},
          {{0, 0}, {0, 10}, 0}, {{10, 0}, {10, low}, 0}, {{10, 10}, {10, high}, 0}};
}

}  // namespace avo::test
