// SPDX-License-Identifier: Apache-2.0
// The half-plane of a wall: soundness, agreement with brute force, and with that of a disc.
#include "obstacles/wall_half_plane.h"

#include <cmath>
#include <gtest/gtest.h>

#include "support/generators.h"
#include "support/slow_walls.h"

namespace avo {
namespace {

using test::Random;
using test::WallSituation;

RelativeHalfPlane plane_of(const WallSituation& s) {
  return wall_half_plane(s.pair, s.reach, Horizon(s.control_time, s.time_horizon, 0.1));
}

// The least support of the sampled hull is off by a refinement error of this part of the reach.
constexpr double kSlowError = 1e-6;

WallSituation any_situation(Random& random, int k) {
  return k % 3 == 0 ? test::degenerate_wall_situation(random) : test::any_wall_situation(random);
}

TEST(WallHalfPlane, agrees_with_brute_force) {
  Random random(2011);
  int compared = 0, failures = 0;
  for (int k = 0; compared < 2'000 && failures < 10; ++k) {
    const WallSituation s = any_situation(random, k);
    // in contact the support is known to rounding over a short time only
    if (!test::is_apart(s, 1e-5)) continue;
    const test::SlowWallHull hull(s);
    if (hull.empty()) continue;  // samples may miss what is hardly within reach
    const auto [n, h] = hull.least();
    if (h >= s.reach * (1.0 - kSlowError)) continue;  // everything within reach collides
    const RelativeHalfPlane plane = plane_of(s);
    ++compared;
    const double tolerance = kSlowError * (s.reach + std::abs(h));
    if (plane.state != PairState::constrained) {
      ADD_FAILURE() << "no half-plane, but brute force has h = " << h << "\n" << s;
      ++failures;
      continue;
    }
    const double support = hull.support(plane.plane.normal), offset = plane.plane.offset;
    if (offset < support - tolerance) {
      ADD_FAILURE() << "optimistic by " << support - offset << ", h " << offset << ", least " << h
                    << "\n"
                    << s;
      ++failures;
    } else if (offset > h + tolerance &&
               // sampling misses points of the hull: more samples before blaming
               offset > test::SlowWallHull(s, 20'000).support(n) + tolerance) {
      ADD_FAILURE() << "too cautious by " << offset - h << ", h " << offset << "\n" << s;
      ++failures;
    }
  }
}

}  // namespace
}  // namespace avo
