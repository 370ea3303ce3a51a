// SPDX-License-Identifier: Apache-2.0
// Starts and goals of robots: circles, blocks, random places.
#include "placement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "avo/error.h"

namespace avo::safety {
namespace {

bool is_clear(std::span<const Vec2> placed, std::span<const double> radii, Vec2 center,
              double clearance) {
  const double radius = radii[placed.size()];
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (norm(center - placed[i]) < radius + radii[i] + clearance) return false;
  }
  return true;
}

// Returns as many of `count` places as fit: `draw` proposes a place, and `is_clear` compares it
// with the taken places.
template <class Draw, class IsClear>
std::vector<Vec2> try_places(std::size_t count, Draw draw, IsClear is_clear) {
  constexpr int kTries = 20000;  // for one place
  std::vector<Vec2> placed;
  for (int tries = 0; placed.size() < count && tries < kTries; ++tries) {
    const Vec2 place = draw();
    if (!is_clear(placed, place)) continue;
    placed.push_back(place);
    tries = 0;
  }
  return placed;
}

// Returns all of `count` places. `room` names the area in messages.
template <class Draw, class IsClear>
std::vector<Vec2> find_places(std::size_t count, const std::string& room, Draw draw,
                              IsClear is_clear) {
  constexpr int kStarts = 200;
  for (int start = 0; start < kStarts; ++start) {
    std::vector<Vec2> placed = try_places(count, draw, is_clear);
    if (placed.size() == count) return placed;
  }
  throw Error("placement: found no room for " + std::to_string(count) + " discs, must fit " + room);
}

}  // namespace

std::vector<Vec2> block(Vec2 center, int columns, int rows, double spacing) {
  std::vector<Vec2> points;
  const Vec2 corner = center - 0.5 * spacing * Vec2{double(columns - 1), double(rows - 1)};
  for (int k = 0; k < columns * rows; ++k) {
    const int row = k / columns, column = k % columns;
    points.push_back(corner + spacing * Vec2{double(column), double(row)});
  }
  return points;
}

std::vector<Vec2> triangular_block(int columns, int rows, double spacing) {
  std::vector<Vec2> points = block({}, columns, rows, spacing);
  for (int k = 0; k < columns * rows; ++k) {
    Vec2& point = points[static_cast<std::size_t>(k)];
    point.x += (k / columns % 2 == 0 ? -0.25 : 0.25) * spacing;
    point.y *= std::sqrt(0.75);
  }
  return points;
}

std::vector<Vec2> random_places(std::span<const double> radii, double side, double clearance,
                                Random& random) {
  return find_places(
      radii.size(), "a square of " + std::to_string(side) + " m",
      [&] { return random.in_square(side); },
      [&](const std::vector<Vec2>& placed, Vec2 center) {
        return is_clear(placed, radii, center, clearance);
      });
}

double wall_clearance(Vec2 place, const Wall& wall) {
  const Vec2 along = wall.b - wall.a;
  const double length_squared = norm_squared(along);
  const double part = length_squared > 0.0
                          ? std::clamp(dot(place - wall.a, along) / length_squared, 0.0, 1.0)
                          : 0.0;
  return norm(place - (wall.a + part * along)) - wall.radius;
}

std::vector<Vec2> places_among(std::span<const Wall> walls, const Area& area, int count,
                               const Spacing& spacing, Random& random,
                               const std::function<bool(Vec2)>& fits) {
  const auto draw = [&] {
    const double x = random.between(area.low.x, area.high.x);
    return Vec2{x, random.between(area.low.y, area.high.y)};
  };
  const auto is_clear = [&](const std::vector<Vec2>& placed, Vec2 place) {
    if (fits && !fits(place)) return false;
    for (const Wall& wall : walls) {
      if (wall_clearance(place, wall) < spacing.to_walls) return false;
    }
    for (const Vec2 other : placed) {
      if (norm(place - other) < spacing.to_others) return false;
    }
    return true;
  };
  return find_places(static_cast<std::size_t>(count), "their area among walls", draw, is_clear);
}

std::vector<Vec2> dealt_anew(std::vector<Vec2> points, Random& random) {
  for (std::size_t i = points.size() - 1; i > 0; --i) std::swap(points[i], points[random.below(i)]);
  return points;
}

}  // namespace avo::safety
