// SPDX-License-Identifier: Apache-2.0
// Shortest paths of a car: they end at their goals, and no path by other words is shorter.
#include "navigator/dubins.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <span>

#include "core/plane.h"
#include "support/generators.h"

namespace avo {
namespace {

Pose driven(Pose at, std::span<const PathPiece> pieces) {
  for (const PathPiece& piece : pieces) {
    const double turn = piece.curvature * piece.length, half = at.heading + 0.5 * turn;
    const double chord = turn == 0.0 ? piece.length : 2.0 * std::sin(0.5 * turn) / piece.curvature;
    at.place = at.place + chord * Vec2{std::cos(half), std::sin(half)};
    at.heading += turn;
  }
  return at;
}

double length(std::span<const PathPiece> pieces) {
  double sum = 0.0;
  for (const PathPiece& piece : pieces) sum += piece.length;
  return sum;
}

TEST(Dubins, leads_to_the_goal) {
  test::Random random(3);
  for (int k = 0; k < 5000; ++k) {
    const double radius = random.uniform(0.3, 3.0);
    const Pose from{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(-7, 7)};
    const Pose to{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(-7, 7)};
    const auto path = dubins_path(from, to, radius);
    const Pose end = driven(from, path);
    ASSERT_LT(norm(end.place - to.place), 1e-3) << k;
    ASSERT_LT(std::abs(wrapped(end.heading - to.heading)), 1e-3) << k;
    ASSERT_GE(length(path), norm(to.place - from.place) - 1e-9);
  }
}

// Any path of two arcs and a straight piece, or of three arcs, is at least as long.
TEST(Dubins, is_no_longer_than_other_ways) {
  test::Random random(4);
  for (int k = 0; k < 300; ++k) {
    const Pose from;
    std::array<PathPiece, 3> way;
    for (PathPiece& piece : way) {
      const double side = random.uniform(-1.0, 1.0);
      piece = {side < -0.3 ? -1.0 : side > 0.3 ? 1.0 : 0.0, random.uniform(0.0, 6.0)};
    }
    const auto path = dubins_path(from, driven(from, way), 1.0);
    EXPECT_LE(length(path), length(way) + 1e-3) << k;
  }
}

}  // namespace
}  // namespace avo
