// SPDX-License-Identifier: Apache-2.0
// Starts and goals of robots: circles, blocks, random places. The bits are the same on every
// machine.
#pragma once
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "avo/vec.h"
#include "avo/wall.h"
#include "io/scene/circle_point.h"

namespace avo::safety {

inline constexpr double kPi = 3.141592653589793;

/// The standard fixes the numbers of the engine, but not those of its distributions, so the
/// distributions are our own.
class Random {
 public:
  /// Streams of one seed are independent enough for all purposes of scenes.
  Random(std::uint64_t seed, std::uint64_t stream) : engine_(seed * 1000003U + stream) {}

  /// Returns a number uniform in [min, max).
  double between(double min, double max) { return min + (max - min) * unit(); }
  /// Returns a number uniform in 0 ... count - 1, count > 0.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(unit() * static_cast<double>(count));
  }
  /// Returns a point uniform in the square of this side about the origin.
  Vec2 in_square(double side) {
    const double x = between(-0.5 * side, 0.5 * side);
    return {x, between(-0.5 * side, 0.5 * side)};
  }

 private:
  double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  std::mt19937_64 engine_;
};

using avo_io::circle_point;

/// Returns columns x rows points about `center`, row by row from the lower left.
std::vector<Vec2> block(Vec2 center, int columns, int rows, double spacing);

/// Returns the densest arrangement of equal discs, row by row about the origin.
std::vector<Vec2> triangular_block(int columns, int rows, double spacing);

/// Returns a point for each radius, uniform in the square of `side`, with `clearance` between any
/// two discs. It starts again if one finds no room, and throws Error if that continues.
std::vector<Vec2> random_places(std::span<const double> radii, double side, double clearance,
                                Random& random);

/// An area from `low` to `high` along each axis, m.
struct Area {
  Vec2 low, high;
};

/// The least distances of a place, m.
struct Spacing {
  double to_others, to_walls;
};

/// Returns `count` places, uniform in the points of the area that have these distances and that
/// `fits` accepts, if it is given. It starts again and throws Error like random_places().
std::vector<Vec2> places_among(std::span<const Wall> walls, const Area& area, int count,
                               const Spacing& spacing, Random& random,
                               const std::function<bool(Vec2)>& fits = {});

/// Returns m, from a place to the surface of the wall; negative inside.
double wall_clearance(Vec2 place, const Wall& wall);

/// Returns the points permuted such that none stays (one cycle through all). There must be two or
/// more.
std::vector<Vec2> dealt_anew(std::vector<Vec2> points, Random& random);

}  // namespace avo::safety
