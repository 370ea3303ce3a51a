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
  for (int k = 0; compared < 600 && failures < 10; ++k) {
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

// Nothing on the line n . w = h, within reach, collides: the nearest point, the ends, and others.
// Nothing at all within reach collides where there is no half-plane.
TEST(WallHalfPlane, no_reachable_point_of_the_line_collides) {
  Random random(15);
  int constrained = 0, free = 0, failures = 0;
  for (int k = 0; constrained < 12'000 && failures < 10; ++k) {
    const WallSituation s = any_situation(random, k);
    const RelativeHalfPlane plane = plane_of(s);
    const auto collides = [&](Vec2 w) {
      const double distance = test::slow_distance(s, w, 400);
      if (distance >= s.pair.radius * (1.0 - 1e-7)) return false;
      ADD_FAILURE() << "w " << w.x << ", " << w.y << " gets to " << distance << ", h "
                    << plane.plane.offset << "\n"
                    << s;
      ++failures;
      return true;
    };
    if (plane.state == PairState::free) {
      ++free;
      for (int i = 0; i < 6 && !collides(0.999999 * s.reach * random.direction()); ++i) continue;
      continue;
    }
    if (plane.state != PairState::constrained) continue;
    ++constrained;
    const auto [n, h] = plane.plane;
    EXPECT_NEAR(norm(n), 1.0, 1e-12);
    const double half = std::sqrt(std::max(0.0, (s.reach - h) * (s.reach + h)));
    for (const double part : {-0.9999999, -0.7, -0.2, 0.0, 0.3, 0.8, 0.9999999}) {
      if (collides(h * n + (part * half) * perpendicular(n))) break;
    }
  }
  EXPECT_GT(free, 600);
}

// A wall without length is a disc, and so is a wall of which only one end matters.
TEST(WallHalfPlane, of_a_point_is_that_of_a_disc) {
  Random random(3);
  for (int k = 0; k < 10'000; ++k) {
    const test::Situation s =
        k % 2 == 0 ? test::degenerate_situation(random) : test::wide_situation(random);
    const Horizon horizon(s.control_time, s.time_horizon, 0.1);
    const RelativeHalfPlane disc = half_plane(s.pair, s.reach, horizon);
    const RelativeHalfPlane wall = wall_half_plane(
        {s.pair.position, s.pair.position, s.pair.velocity, s.pair.radius}, s.reach, horizon);
    EXPECT_EQ(wall.state, disc.state) << s;
    EXPECT_EQ(wall.plane.normal, disc.plane.normal) << s;
    EXPECT_EQ(wall.plane.offset, disc.plane.offset) << s;
  }
}

// The general search finds the same: a wall of next to no length.
TEST(WallHalfPlane, of_a_short_wall_is_that_of_a_disc_to_its_length) {
  Random random(4);
  int constrained = 0;
  for (int k = 0; k < 20'000; ++k) {
    const test::Situation s = test::wide_situation(random);
    const Horizon horizon(s.control_time, s.time_horizon, 0.1);
    const RelativeHalfPlane disc = half_plane(s.pair, s.reach, horizon);
    const Vec2 p = s.pair.position, end = p + (1e-9 * s.pair.radius) * random.direction();
    const RelativeHalfPlane wall =
        wall_half_plane({p, end, s.pair.velocity, s.pair.radius}, s.reach, horizon);
    if (disc.state != PairState::constrained || wall.state != PairState::constrained) continue;
    ++constrained;
    const double gap = norm(p) - s.pair.radius;
    EXPECT_NEAR(wall.plane.offset, disc.plane.offset,
                1e-6 * (s.reach + std::abs(disc.plane.offset)) * (1.0 + s.pair.radius / gap))
        << s;
  }
  EXPECT_GT(constrained, 3'000);
}

// Head-on to the middle of a short wall, both routes around the wall are equally far. The robot
// takes the route to the left of the wall's normal, whatever rounding does.
TEST(WallHalfPlane, ties_go_to_the_left) {
  Random random(5);
  const Horizon horizon(2.0, 6.0, 0.1);
  for (int k = 0; k < 2000; ++k) {
    const Vec2 n = random.direction(), along = perpendicular(n);
    const double half = random.uniform(0.1, 0.4), away = random.uniform(3.0, 4.0);
    WallPair pair{away * n + half * along, away * n - half * along, -2.0 * n, 0.5};
    if (k % 2 == 0) std::swap(pair.from_a, pair.from_b);
    for (const RelativeHalfPlane& plane :
         {wall_half_plane(pair, 4.0, horizon), orca_wall_half_plane(pair, 6.0, 0.1)}) {
      EXPECT_EQ(plane.state, PairState::constrained);
      EXPECT_GT(dot(plane.plane.normal, along), 0.5);
    }
  }
}

TEST(WallHalfPlane, the_order_of_the_ends_does_not_matter) {
  Random random(6);
  for (int k = 0; k < 20'000; ++k) {
    const WallSituation s = any_situation(random, k);
    WallSituation swapped = s;
    std::swap(swapped.pair.from_a, swapped.pair.from_b);
    const RelativeHalfPlane one = plane_of(s), other = plane_of(swapped);
    if (!test::is_apart(s, 1e-5)) continue;
    EXPECT_EQ(one.state, other.state) << s;
    EXPECT_NEAR(one.plane.offset, other.plane.offset, 1e-7 * (s.reach + std::abs(one.plane.offset)))
        << s;
  }
}

// The velocity obstacle of a wall is convex: no support along a normal of it is smaller.
TEST(OrcaWall, no_velocity_of_the_line_collides_and_none_is_nearer) {
  Random random(8);
  int outside = 0;
  for (int k = 0; k < 20'000; ++k) {
    const WallSituation s = any_situation(random, k);
    if (!test::is_apart(s, 1e-6)) continue;
    const double tau = s.time_horizon;
    const RelativeHalfPlane plane = orca_wall_half_plane(s.pair, tau, 0.1);
    ASSERT_EQ(plane.state, PairState::constrained);
    const auto [n, h] = plane.plane;
    EXPECT_NEAR(norm(n), 1.0, 1e-12);
    const Vec2 b = s.pair.from_a - s.pair.from_b;
    const auto nearest = [&](Vec2 w) {  // along a straight line, by the ends and the crossing
      const Vec2 way = tau * (s.pair.velocity + w), from = s.pair.from_a, to = from + way;
      const double side_0 = cross(b, from), side_1 = cross(b, to);
      const double end_0 = cross(way, -from), end_1 = cross(way, b - from);
      if (side_0 * side_1 < 0.0 && end_0 * end_1 < 0.0) return 0.0;
      return std::min(
          {test::slow_segment_distance(from, {}, b), test::slow_segment_distance(to, {}, b),
           test::slow_segment_distance({}, from, to), test::slow_segment_distance(b, from, to)});
    };
    const double r = s.pair.radius;
    for (const double part : {-20.0, -3.0, -0.5, 0.0, 0.3, 2.0, 30.0})
      EXPECT_GE(nearest(h * n + part * perpendicular(n)), r * (1.0 - 1e-9)) << s;
    // within |h| of 0 all collide, or none does
    const bool collides = nearest({}) < r;
    outside += collides ? 0 : 1;
    for (int i = 0; i < 4; ++i) {
      const Vec2 w = (1.0 - 1e-9) * std::abs(h) * random.direction();
      if (collides)
        EXPECT_LT(nearest(w), r * (1.0 + 1e-9)) << s;
      else
        EXPECT_GT(nearest(w), r * (1.0 - 1e-9)) << s;
    }
    // one of the line is on the obstacle's edge
    const double deeper = h - 1e-6 * (1.0 + std::abs(h));
    bool touches = false;
    for (int i = -4000; i <= 4000 && !touches; ++i) {
      const double part =
          i == 0 ? 0.0 : std::copysign(std::pow(10.0, std::abs(i) / 500.0 - 6.0), i);
      touches = nearest(deeper * n + part * perpendicular(n)) < r;
    }
    EXPECT_TRUE(touches) << s << " h " << h;
  }
  EXPECT_GT(outside, 5'000);
}

}  // namespace
}  // namespace avo
