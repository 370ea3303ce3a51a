// SPDX-License-Identifier: Apache-2.0
// Half-planes of many pairs at once: sound, odd, turned, mirrored, ties.
#include "obstacles/half_planes.h"

#include <cmath>
#include <gtest/gtest.h>

#include "avo/velocity_obstacle.h"
#include "support/half_plane_batches.h"

namespace avo {
namespace {

using test::Batch;
using test::Random;
using test::Situation;

constexpr int kBatches = 600;
constexpr std::size_t kSize = 256;

// This is a part of r, near contact.
constexpr double kOverlap = 1e-7;
constexpr double kRounding = 0x1p-53;
// |sin| up to which p and v are parallel: kTie, and its rounding.
constexpr double kParallel = 2e-9;

template <typename Map>
std::vector<Situation> mapped(std::vector<Situation> all, Map map) {
  for (Situation& s : all) {
    s.pair.position = map(s.pair.position);
    s.pair.velocity = map(s.pair.velocity);
  }
  return all;
}

// -0 is as good as 0.
template <typename Map>
void expect_mapped(const RelativeHalfPlane& found, const RelativeHalfPlane& original, Map map,
                   const Situation& s) {
  ASSERT_EQ(found.state, original.state) << s;
  ASSERT_EQ(found.plane.normal, map(original.plane.normal)) << s;
  ASSERT_EQ(found.plane.offset, original.plane.offset) << s;
  ASSERT_EQ(found.excess, original.excess) << s;
}

// Nothing that is within reach and in the half-plane collides, on its line nor beyond; nothing at
// all within reach where there is no half-plane.
TEST(HalfPlanes, P3_what_they_admit_does_not_collide) {
  Batch batch;
  Random random(31);
  int constrained = 0, free = 0;
  for (int k = 0; k < kBatches && !testing::Test::HasFailure(); ++k) {
    const auto all = test::situations_of_one_horizon(random, kSize, k % 2 == 0);
    batch.solve(all, test::horizon_of(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Situation& s = all[i];
      const RelativeHalfPlane found = batch[i];
      const Obstacle obstacle = test::obstacle_of(s);
      const auto expect_apart = [&](Vec2 w) {
        const double distance = closest_approach(obstacle, s.pair.velocity + w).distance;
        EXPECT_GE(distance, s.pair.radius * (1.0 - kOverlap))
            << "w " << w.x << ", " << w.y << " h " << found.plane.offset << "\n"
            << s;
      };
      if (found.state == PairState::free) {
        ++free;
        for (int j = 0; j < 4; ++j) expect_apart(test::in_disc(random, s.reach));
      }
      if (found.state != PairState::constrained) continue;
      ++constrained;
      const Vec2 n = found.plane.normal;
      // n is a unit vector to rounding only: the line is where n . w = h all the same
      const double length = norm(n), h = found.plane.offset / length;
      ASSERT_NEAR(length, 1.0, 8.0 * kRounding) << s;
      if (std::abs(h) > s.reach) continue;
      const double half = std::sqrt((s.reach - h) * (s.reach + h));
      for (const double part : {0.0, -1.0, 1.0, random.uniform(-1.0, 1.0)}) {
        expect_apart((1.0 / length) * (h * n + (part * half) * perpendicular(n)));
      }
      const Vec2 w = test::in_disc(random, s.reach);
      if (dot(n, w) >= found.plane.offset) expect_apart(w);
    }
  }
  EXPECT_GT(constrained, 40'000);
  EXPECT_GT(free, 5'000);
}

// Where a step of the search for the crossing happens to be tiny, the next is not made from two
// points that differ by rounding.
TEST(HalfPlanes, P3_tiny_steps_towards_a_crossing_end_no_search) {
  Batch batch;
  for (const Situation& s : {Situation{{{-4.8841251634019063, -1.993916870801274},
                                        {2.2015201452919504, 0.43834581162565339},
                                        1.0},
                                       2.3185757060354648,
                                       0.46464559783474646,
                                       7.283145021897889},
                             Situation{{{0.053386130285576802, 1.0059681128727349},
                                        {-0.6100505552272607, -0.95161671782467527},
                                        0.49781723652576915},
                                       1.8940392364495664,
                                       0.5,
                                       10.0}}) {
    batch.solve({s}, test::horizon_of({s}));
    const HalfPlane plane = batch[0].plane;
    const double half = std::sqrt((s.reach - plane.offset) * (s.reach + plane.offset));
    for (const double part : {-1.0, 0.0, 1.0}) {
      const Vec2 w = plane.offset * plane.normal + (part * half) * perpendicular(plane.normal);
      const double distance = closest_approach(test::obstacle_of(s), s.pair.velocity + w).distance;
      EXPECT_GE(distance, s.pair.radius * (1.0 - 1e-6)) << part << "\n" << s;
    }
  }
}

// The line belongs to the first of many times at which the pair can be apart. The demand of a
// window falls as the window grows. Where there is no such time, the line belongs to the last time.
TEST(HalfPlanes, overlapping_pairs_part_within_the_shortest_window) {
  Batch batch;
  constexpr int kTimes = 1000;
  Random random(60);
  int at_once = 0, later = 0, never = 0;
  for (int k = 0; k < kBatches && !testing::Test::HasFatalFailure(); ++k) {
    auto all = test::situations_of_one_horizon(random, 16, k % 2 == 0);
    for (Situation& s : all) s = test::touching(random, s);
    batch.solve(all, test::horizon_of(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Situation& s = all[i];
      const double d = norm(s.pair.position), R = s.reach;
      const double step = 0.1, last = std::max(step, s.time_horizon);
      const RelativeHalfPlane found = batch[i];
      if (found.state != PairState::overlapping || !(d > 0.0)) continue;
      const Vec2 n = s.pair.position / d;
      ASSERT_LE(norm(found.plane.normal - n), 8.0 * kRounding) << s;
      const Response response = Response::proportional(s.control_time);
      const auto demand = [&](double T) {
        return (s.pair.radius - d - T * dot(n, s.pair.velocity)) / response.gain(T);
      };
      const auto time = [&](int j) { return step + (last - step) * j / kTimes; };
      int first = 0;
      while (first <= kTimes && demand(time(first)) > R) ++first;
      const double rounding =
          64.0 * kRounding *
          (R + (s.pair.radius + step * norm(s.pair.velocity)) / response.gain(step));
      const double least = first <= kTimes ? std::min(demand(time(first)), R) : R;
      const double most = first == 0 ? least : R;
      ASSERT_GE(found.plane.offset, least - rounding) << s;
      ASSERT_LE(found.plane.offset, most + rounding) << s;
      const double excess = first <= kTimes ? 0.0 : demand(last) - R;
      ASSERT_NEAR(found.excess, excess, rounding) << s;
      ++(first == 0 ? at_once : first <= kTimes ? later : never);
    }
  }
  EXPECT_GT(at_once, 500);
  EXPECT_GT(later, 500);
  EXPECT_GT(never, 500);
}

TEST(HalfPlanes, P7_exchanging_the_robots_negates_them_bit_for_bit) {
  Batch batch, other;
  Random random(7);
  const auto negated = [](Vec2 a) { return -a; };
  for (int k = 0; k < kBatches && !testing::Test::HasFatalFailure(); ++k) {
    const auto all = test::situations_of_one_horizon(random, kSize, k % 2 == 0);
    batch.solve(all, test::horizon_of(all));
    other.solve(mapped(all, negated), test::horizon_of(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
      expect_mapped(other[i], batch[i], negated, all[i]);
    }
  }
}

TEST(HalfPlanes, P6_turning_by_90_degrees_turns_them_bit_for_bit) {
  Batch batch, other;
  Random random(6);
  const auto turned = [](Vec2 a) { return perpendicular(a); };
  for (int k = 0; k < kBatches && !testing::Test::HasFatalFailure(); ++k) {
    const auto all = test::situations_of_one_horizon(random, kSize, k % 2 == 0);
    batch.solve(all, test::horizon_of(all));
    other.solve(mapped(all, turned), test::horizon_of(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
      expect_mapped(other[i], batch[i], turned, all[i]);
    }
  }
}

TEST(HalfPlanes, P6_mirroring_mirrors_them_bit_for_bit) {
  Batch batch, other;
  Random random(66);
  const auto mirrored = [](Vec2 a) { return Vec2{a.x, -a.y}; };
  for (int k = 0; k < kBatches && !testing::Test::HasFatalFailure(); ++k) {
    const auto all = test::situations_of_one_horizon(random, kSize, k % 2 == 0);
    batch.solve(all, test::horizon_of(all));
    other.solve(mapped(all, mirrored), test::horizon_of(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vec2 p = all[i].pair.position, v = all[i].pair.velocity;
      if (!(std::abs(cross(p, v)) > kParallel * norm(p) * norm(v))) continue;  // a tie
      expect_mapped(other[i], batch[i], mirrored, all[i]);
    }
  }
}

TEST(HalfPlanes, P6_ties_are_broken_towards_the_left_of_p) {
  Batch batch;
  Random random(5);
  std::size_t planes = 0;
  for (int k = 0; k < kBatches && !testing::Test::HasFatalFailure(); ++k) {
    auto all = test::situations_of_one_horizon(random, kSize, k % 2 == 0);
    for (Situation& s : all) {  // on an axis, so that p and v are parallel exactly
      const double share = random.below(4) == 0 ? 0.0 : random.uniform(-2.0, 1.0);
      const bool along_x = random.below(2) == 0;
      const double d = norm(s.pair.position), speed = share * norm(s.pair.velocity);
      s.pair.position = along_x ? Vec2{d, 0.0} : Vec2{0.0, d};
      s.pair.velocity = along_x ? Vec2{speed, 0.0} : Vec2{0.0, speed};
    }
    batch.solve(all, test::horizon_of(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const RelativeHalfPlane found = batch[i];
      if (found.state != PairState::constrained && found.state != PairState::unavoidable) continue;
      ++planes;
      ASSERT_GE(dot(found.plane.normal, perpendicular(all[i].pair.position)), 0.0) << all[i];
    }
  }
  EXPECT_GT(planes, 10'000);
}

}  // namespace
}  // namespace avo
