// SPDX-License-Identifier: Apache-2.0
// The half-plane of Eqs. (15), (16): soundness, agreement with brute force, symmetries.
#include "avo/half_plane.h"

#include <cfenv>
#include <cmath>
#include <gtest/gtest.h>

#include "support/brute_force.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;
using test::Situation;

RelativeHalfPlane half_plane_of(const Situation& s) {
  return half_plane(s.pair, s.reach, Horizon(s.control_time, s.time_horizon, 0.1));
}

// The least support of the sampled hull is off by a refinement error of this part of the reach.
constexpr double kSlowError = 1e-7;
// Near contact the offset is known to fewer digits, and is kept on the safe side.
constexpr double kCaution = 1e-6;

TEST(HalfPlane, P3_agrees_with_brute_force) {
  Random random(2011);
  int compared = 0, failures = 0;
  for (int k = 0; compared < 10'000 && failures < 10; ++k) {
    const Situation s =
        k % 4 == 0 ? test::degenerate_situation(random) : test::wide_situation(random);
    // in contact the support is known to rounding over a short time only: see the next test
    if (norm(s.pair.position) < (1.0 + 1e-7) * s.pair.radius) continue;
    const test::SlowHull hull(s);
    if (hull.empty()) continue;  // samples may miss what is hardly within reach
    const auto [n, h] = hull.least();
    if (h >= s.reach * (1.0 - kSlowError)) continue;  // everything within reach collides
    const RelativeHalfPlane found = half_plane_of(s);
    ++compared;
    const double tolerance = kSlowError * (s.reach + std::abs(h));
    const double cautious = kCaution * (s.reach + std::abs(h));
    if (found.state != PairState::constrained) {
      ADD_FAILURE() << "no half-plane, but brute force has h = " << h << "\n" << s;
      ++failures;
    } else if (const double support = hull.support(found.plane.normal);
               found.plane.offset < support - tolerance) {
      ADD_FAILURE() << "optimistic by " << support - found.plane.offset << ", h "
                    << found.plane.offset << ", least " << h << "\n"
                    << s;
      ++failures;
    } else if (found.plane.offset > h + cautious &&
               // sampling misses points of the hull: more samples before blaming
               found.plane.offset > test::SlowHull(s, 20'000).support(n) + cautious) {
      ADD_FAILURE() << "too cautious by " << found.plane.offset - h << ", h " << found.plane.offset
                    << "\n"
                    << s;
      ++failures;
    }
  }
}

// Nothing on the line n . w = h, within reach, collides: the nearest point, the ends, and others.
// Nothing at all within reach collides where there is no half-plane.
TEST(HalfPlane, P3_no_reachable_point_of_the_line_collides) {
  Random random(15);
  int constrained = 0, free = 0, failures = 0;
  while (constrained < 100'000 && failures < 10) {
    const Situation s = test::any_situation(random);
    const RelativeHalfPlane found = half_plane_of(s);
    const Obstacle obstacle = test::obstacle_of(s);
    const auto collides = [&](Vec2 w) {
      const double distance = closest_approach(obstacle, s.pair.velocity + w).distance;
      if (distance >= s.pair.radius * (1.0 - 1e-7)) return false;
      ADD_FAILURE() << "w " << w.x << ", " << w.y << " gets to " << distance << ", h "
                    << found.plane.offset << "\n"
                    << s;
      ++failures;
      return true;
    };
    if (found.state == PairState::free) {
      ++free;
      collides(test::in_disc(random, s.reach));
      continue;
    }
    ASSERT_LE(std::abs(found.plane.offset), s.reach) << s;
    if (found.state == PairState::unavoidable) {
      EXPECT_EQ(found.plane.offset, s.reach);
      EXPECT_GT(found.excess, 0.0);
      continue;
    }
    ASSERT_EQ(found.state, PairState::constrained) << s;
    const HalfPlane& plane = found.plane;
    ++constrained;
    const double half = std::sqrt((s.reach - plane.offset) * (s.reach + plane.offset));
    for (const double part : {0.0, -1.0, 1.0, -random.near_zero(), random.uniform(-1.0, 0.0),
                              random.uniform(0.0, 1.0), random.uniform(-0.3, 0.3)}) {
      if (collides(plane.offset * plane.normal + (part * half) * perpendicular(plane.normal)))
        break;
    }
  }
  EXPECT_GT(free, 10'000);
}

// A slow pass: its near side leaves the reach, is back for a moment, and leaves it again.
TEST(HalfPlane, P3_four_crossings_are_all_seen) {
  const Situation s{{{-0.38720892161667686, 0.83100530948300078},
                     {0.10072140370822175, 0.043642682495828145},
                     0.91493000710552264},
                    0.076278738175479213,
                    3.8444073194969781,
                    72.677258182643939};
  const RelativeHalfPlane found = half_plane_of(s);
  ASSERT_EQ(found.state, PairState::constrained);
  const double support = test::SlowHull(s, 20'000).support(found.plane.normal);
  EXPECT_NEAR(found.plane.offset, support, kCaution * s.reach);
}

// On collision course to rounding, beside it by the miss distance.
TEST(HalfPlane, of_a_pair_that_just_touches_rests_on_no_invalid_operation) {
  std::feclearexcept(FE_ALL_EXCEPT);
  const RelativeHalfPlane found = half_plane_of({{{0.49229757561394505, -1.3522972367258332},
                                                  {0.3105049029390336, 4.058030591550712},
                                                  0.59403374888367189},
                                                 4.0,
                                                 2.0,
                                                 10.0});
  EXPECT_EQ(found.state, PairState::constrained);
  EXPECT_FALSE(std::fetestexcept(FE_INVALID));
}

// In contact to rounding, and moving across it to rounding: here the miss distance is r to
// rounding, and the time of the closest approach means nothing.
TEST(HalfPlane, P3_in_grazing_contact_no_reachable_point_of_the_line_collides) {
  Random random(16);
  int constrained = 0;
  const auto expect_sound = [&](const Situation& s) {
    const RelativeHalfPlane found = half_plane_of(s);
    if (found.state != PairState::constrained) return;
    ++constrained;
    const Obstacle obstacle = test::obstacle_of(s);
    const HalfPlane& plane = found.plane;
    const double half = std::sqrt((s.reach - plane.offset) * (s.reach + plane.offset));
    for (const double part : {-1.0, -0.7, -0.3, -0.1, 0.0, 0.1, 0.3, 0.7, 1.0}) {
      const Vec2 w = plane.offset * plane.normal + (part * half) * perpendicular(plane.normal);
      const double distance = closest_approach(obstacle, s.pair.velocity + w).distance;
      ASSERT_GE(distance, s.pair.radius * (1.0 - 1e-7)) << "h " << plane.offset << "\n" << s;
    }
  };
  expect_sound({{{0.0034592829027850079, -0.0015252988397861391},
                 {0.001540811926148565, 0.0034944657985906016},
                 0.0037806315282176879},
                0.0018878337049181612,
                0.080256963212307672,
                0.98356290424638215});
  for (int k = 0; k < 20'000 && !HasFailure(); ++k) {
    Situation s = test::wide_situation(random);
    const Vec2 across = perpendicular(s.pair.position) / norm(s.pair.position);
    const double speed = norm(s.pair.velocity), slope = random.log_uniform(1e-16, 1e-6);
    s.pair.velocity = speed * (across + (k % 2 == 0 ? slope : -slope) * perpendicular(across));
    const double gap = k % 3 == 0 ? random.log_uniform(1e-16, 1e-8) : 0.0;
    s.pair.position = (s.pair.radius * (1.0 + gap)) * -perpendicular(across);
    expect_sound(s);
  }
  EXPECT_GT(constrained, 5'000);
}

}  // namespace
}  // namespace avo
