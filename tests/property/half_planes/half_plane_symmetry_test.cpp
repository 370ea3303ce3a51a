// SPDX-License-Identifier: Apache-2.0
// The half-plane of a pair seen from the other robot, turned, mirrored and scaled, bit for bit;
// what it guarantees to two robots that share it; its limits.
#include <cmath>
#include <gtest/gtest.h>

#include "avo/half_plane.h"
#include "support/cases.h"
#include "support/generators.h"
#include "support/sampled_half_plane.h"

namespace avo {
namespace {

using test::Random;
using test::Situation;

RelativeHalfPlane half_plane_of(const Situation& s) {
  return half_plane(s.pair, s.reach, Horizon(s.control_time, s.time_horizon, 0.1));
}
RelativeHalfPlane orca_half_plane_of(const Situation& s) {
  return orca_half_plane(s.pair, s.time_horizon, 0.1);
}

// Any situation, one in eight of them overlapping.
Situation situation(Random& random) {
  Situation s = test::any_situation(random);
  if (random.below(8) == 0) s.pair.position = random.uniform(0.0, 1.0) * s.pair.position;
  return s;
}

template <typename Map>
Situation mapped(Situation s, Map map) {
  s.pair.position = map(s.pair.position);
  s.pair.velocity = map(s.pair.velocity);
  return s;
}

Vec2 negated(Vec2 a) {
  return -a;
}
Vec2 turned(Vec2 a) {
  return perpendicular(a);
}
Vec2 mirrored(Vec2 a) {
  return {a.x, -a.y};
}
Vec2 swapped(Vec2 a) {
  return {a.y, a.x};
}

// == on doubles takes -0 for 0, which is what is wanted here.
template <typename Map>
void expect_mapped(const RelativeHalfPlane& found, const RelativeHalfPlane& original, Map map) {
  EXPECT_TRUE(found.state == original.state);
  EXPECT_TRUE(found.plane.offset == original.plane.offset);
  EXPECT_TRUE(found.plane.normal == map(original.plane.normal));
}

TEST(HalfPlane, P7_exchanging_the_robots_negates_it_bit_for_bit) {
  test::in_all_cases([](Random& random) {
    const Situation s = situation(random);
    expect_mapped(half_plane_of(mapped(s, negated)), half_plane_of(s), negated);
    expect_mapped(orca_half_plane_of(mapped(s, negated)), orca_half_plane_of(s), negated);
  });
}

TEST(HalfPlane, P6_turning_by_90_degrees_turns_it_bit_for_bit) {
  test::in_all_cases([](Random& random) {
    const Situation s = situation(random);
    expect_mapped(half_plane_of(mapped(s, turned)), half_plane_of(s), turned);
    expect_mapped(orca_half_plane_of(mapped(s, turned)), orca_half_plane_of(s), turned);
  });
}

TEST(HalfPlane, P6_mirroring_mirrors_it_bit_for_bit) {
  test::in_all_cases([](Random& random) {
    const Situation s = situation(random);
    // p parallel to v to 1e-9 is a tie, tested below
    if (!(std::abs(cross(s.pair.position, s.pair.velocity)) >
          2e-9 * norm(s.pair.position) * norm(s.pair.velocity)))
      return false;
    expect_mapped(half_plane_of(mapped(s, mirrored)), half_plane_of(s), mirrored);
    expect_mapped(half_plane_of(mapped(s, swapped)), half_plane_of(s), swapped);
    expect_mapped(orca_half_plane_of(mapped(s, mirrored)), orca_half_plane_of(s), mirrored);
    return true;
  });
}

TEST(HalfPlane, P6_ties_are_broken_towards_the_left_of_p) {
  test::in_all_cases([](Random& random) {
    // on an axis, so that p and v are parallel exactly, head-on, at rest or moving apart
    Situation s = test::any_situation(random);
    const double share = random.below(4) == 0 ? 0.0 : random.uniform(-2.0, 1.0);
    s.pair.position = {norm(s.pair.position), 0.0};
    s.pair.velocity = share * (norm(s.pair.velocity) / s.pair.position.x) * s.pair.position;
    for (int quarter = 0; quarter < 4; ++quarter) {
      for (const RelativeHalfPlane& found : {half_plane_of(s), orca_half_plane_of(s)}) {
        if (found.state == PairState::free) continue;
        ASSERT_TRUE(dot(found.plane.normal, perpendicular(s.pair.position)) >= 0.0);
      }
      s = mapped(s, turned);
    }
  });
}

TEST(HalfPlane, P6_powers_of_two_scale_it_bit_for_bit) {
  test::in_all_cases([](Random& random) {
    const Situation s = test::wide_situation(random);
    const int length = random.below(45) - 22, time = random.below(17) - 8;
    const RelativeHalfPlane original = half_plane_of(s);
    const Situation other = test::scaled(s, std::ldexp(1.0, length), std::ldexp(1.0, time));
    const Horizon horizon(other.control_time, other.time_horizon, std::ldexp(0.1, time));
    const RelativeHalfPlane found = half_plane(other.pair, other.reach, horizon);
    ASSERT_TRUE(found.state == original.state);
    ASSERT_TRUE(found.plane.normal == original.plane.normal);
    ASSERT_TRUE(found.plane.offset == std::ldexp(original.plane.offset, length - time));
  });
}

// Lemma 3: each robot anywhere in its own set, Eqs. (17), (18), and the pair does not collide.
TEST(HalfPlane, P8_robots_in_their_sets_do_not_collide) {
  test::in_all_cases([](Random& random) {
    const Situation s = test::any_situation(random);
    const double share = random.uniform(0.05, 0.95);
    const RelativeHalfPlane found = half_plane_of(s);
    if (!(found.state != PairState::unavoidable)) return false;
    const double alpha_A = reciprocal_share(share, 1.0 - share);
    const double alpha_B = reciprocal_share(1.0 - share, share);
    EXPECT_TRUE(std::abs(alpha_A + alpha_B - 1.0) <= 0x1p-52);
    const Vec2 v_B = 0.3 * s.pair.velocity, v_A = s.pair.velocity + v_B;
    const HalfPlane set_A = apportion(found.plane, v_A, alpha_A);
    const HalfPlane set_B = apportion({-found.plane.normal, found.plane.offset}, v_B, alpha_B);
    const auto in_set = [&](const HalfPlane& plane, Vec2 v, double alpha) {
      Vec2 u = v + test::in_disc(random, alpha * s.reach);
      if (found.state == PairState::free) return u;
      // onto the line if outside, as the program would do, but not out of the disc
      const double out = violation(plane, u);
      if (out > 0.0) u = u + out * plane.normal;
      if (norm(u - v) > alpha * s.reach)
        u = v + (plane.offset - dot(plane.normal, v)) * plane.normal;
      return u;
    };
    const Vec2 u = in_set(set_A, v_A, alpha_A) - in_set(set_B, v_B, alpha_B);
    const double distance = closest_approach(test::obstacle_of(s), u).distance;
    EXPECT_TRUE(distance >= s.pair.radius * (1.0 - 1e-7));
    return true;
  });
}

// δ -> 0 with unlimited reach: ORCA. The difference falls like δ.
TEST(HalfPlane, P4_tends_to_orca_as_delta_tends_to_zero) {
  Random random(5);
  int compared = 0;
  for (int k = 0; k < 3000; ++k) {
    Situation s = test::wide_situation(random);
    if (norm(s.pair.position) < 1.1 * s.pair.radius) continue;
    s.control_time = 1e-7 * s.time_horizon;
    s.reach = 1e5;
    const RelativeHalfPlane found = half_plane_of(s);
    const RelativeHalfPlane limit = orca_half_plane_of(s);
    ASSERT_EQ(found.state, PairState::constrained) << s;
    ASSERT_EQ(limit.state, PairState::constrained) << s;
    // the lag δ shifts the pair by δ v, which turns the normal by δ |v| over the gap
    const double gap = norm(s.pair.position) - s.pair.radius;
    const double turn = 10.0 * s.control_time * norm(s.pair.velocity) / gap;
    EXPECT_LE(norm(found.plane.normal - limit.plane.normal), turn + 1e-9) << s;
    EXPECT_NEAR(found.plane.offset, limit.plane.offset,
                (turn + 2e-7) * (norm(s.pair.velocity) + std::abs(limit.plane.offset)))
        << s;
    ++compared;
  }
  EXPECT_GT(compared, 2000);
}

// Chords cut through the obstacle: the sampled half-plane is optimistic, less and less so.
TEST(HalfPlane, P4_samples_tend_to_the_exact_one) {
  double worst[3] = {0.0, 0.0, 0.0};
  double mean[3] = {0.0, 0.0, 0.0};
  int compared = 0;
  Random random(25);
  for (int k = 0; k < 4000 && compared < 60; ++k) {
    const Situation s = test::wide_situation(random);
    const RelativeHalfPlane exact = half_plane_of(s);
    if (exact.state != PairState::constrained || exact.plane.offset > 0.9 * s.reach) continue;
    // uniform times must resolve the time in which the obstacle is entered
    if (norm(s.pair.position) - s.pair.radius <
        0.05 * s.time_horizon * (norm(s.pair.velocity) + s.reach)) {
      continue;
    }
    ++compared;
    const Horizon horizon(s.control_time, s.time_horizon, 0.1);
    for (int i = 0; i < 3; ++i) {
      const int samples = i == 0 ? 25 : i == 1 ? 100 : 400;
      const RelativeHalfPlane found = test::sampled_half_plane(s.pair, s.reach, horizon, samples);
      const double error = found.state == PairState::free
                               ? 1.0 + exact.plane.offset / s.reach
                               : std::abs(exact.plane.offset - found.plane.offset) / s.reach;
      worst[i] = std::max(worst[i], error);
      mean[i] += error;
    }
  }
  EXPECT_EQ(compared, 60);
  EXPECT_GT(worst[0], 1e-4);
  EXPECT_LT(worst[2], 1e-3);
  EXPECT_LT(mean[1], 0.2 * mean[0]);
  EXPECT_LT(mean[2], 0.2 * mean[1]);
}

}  // namespace
}  // namespace avo
