// SPDX-License-Identifier: Apache-2.0
// Many half-planes at once: the bits of half_plane() on every instruction set.
#include "obstacles/half_planes.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <optional>

#include "obstacles/horn.h"
#include "support/half_plane_batches.h"

namespace avo {
namespace {

using test::Batch;
using test::Random;
using test::Situation;

constexpr std::size_t kPairs = 200'000;  // at least, on every target

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(const RelativeHalfPlane& a, const RelativeHalfPlane& b) {
  return a.state == b.state && same_bits(a.plane.normal.x, b.plane.normal.x) &&
         same_bits(a.plane.normal.y, b.plane.normal.y) &&
         same_bits(a.plane.offset, b.plane.offset) && same_bits(a.excess, b.excess);
}

std::string text(const RelativeHalfPlane& a) {
  std::ostringstream out;
  out << std::hexfloat << "state " << static_cast<int>(a.state) << " n " << a.plane.normal.x << ' '
      << a.plane.normal.y << " h " << a.plane.offset << " excess " << a.excess;
  return out.str();
}

void add(HalfPlaneCases& sum, const HalfPlaneCases& more) {
  sum.contact += more.contact, sum.tip += more.tip, sum.convex += more.convex,
      sum.horn += more.horn;
  sum.follow += more.follow, sum.rest += more.rest;
}

// What has been seen: each case and each state has to be.
struct Seen {
  HalfPlaneCases cases;
  std::size_t left_by_the_horn = 0;
  std::map<PairState, std::size_t> states;

  void count(const HalfPlaneCases& more, const std::vector<Situation>& all) {
    add(cases, more);
    std::size_t equal_centers = 0;
    for (const Situation& s : all) equal_centers += s.pair.position == Vec2{} ? 1 : 0;
    left_by_the_horn += more.rest - equal_centers;
  }
};

// Batches of all sizes, until there are enough pairs.
template <typename Each>
void for_each_batch(std::uint64_t seed, Each each) {
  Random random(seed);
  std::size_t pairs = 0;
  for (std::size_t k = 0; pairs < kPairs && !testing::Test::HasFailure(); ++k) {
    const std::size_t size = test::kBatchSizes[k % test::kBatchSizes.size()];
    const std::vector<Situation> all = test::situations_of_one_horizon(random, size, k % 3 != 0);
    each(all, test::horizon_of(all));
    pairs += size;
  }
}

TEST(HalfPlanes, have_the_bits_of_one_pair_at_a_time_on_every_target) {
  std::optional<HalfPlaneCases> cases;
  for (const char* target : simd_targets()) {
    SCOPED_TRACE(target);
    const test::OnTarget on(target);
    Batch batch;
    Seen seen;
    for_each_batch(1, [&](const std::vector<Situation>& all, const Horizon& horizon) {
      batch.solve(all, horizon);
      seen.count(batch.workspace.cases, all);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Situation& s = all[i];
        const RelativeHalfPlane alone = half_plane(s.pair, s.reach, horizon), found = batch[i];
        ++seen.states[alone.state];
        ASSERT_TRUE(same_bits(found, alone)) << i << " of " << all.size() << "\n"
                                             << text(found) << "\n"
                                             << text(alone) << "\n"
                                             << s;
      }
    });
    // only the pairs themselves are counted
    EXPECT_TRUE(cases.value_or(seen.cases) == seen.cases);
    cases = seen.cases;
    EXPECT_GT(seen.cases.contact, 1'000);
    EXPECT_GT(seen.cases.tip, 10'000);
    EXPECT_GT(seen.cases.convex, 10'000);
    EXPECT_GT(seen.cases.horn, 10'000);
    EXPECT_GT(seen.cases.follow, 1'000);
    EXPECT_GT(seen.left_by_the_horn, 1'000);
    for (const PairState state : {PairState::free, PairState::constrained, PairState::unavoidable,
                                  PairState::overlapping, PairState::coincident}) {
      EXPECT_GT(seen.states[state], 100) << static_cast<int>(state);
    }
  }
}

// The pair passes at little more than its radius.
Situation close_pass(Random& random, Situation s) {
  const Vec2 p = s.pair.position;
  const double miss = s.pair.radius * (1.0 + random.log_uniform(1e-4, 1.0));
  const double d = norm(p), sine = std::min(miss / d, 1.0), cosine = std::sqrt(1.0 - sine * sine);
  const double speed = norm(s.pair.velocity);
  s.pair.velocity = (speed / d) * (sine * perpendicular(p) - cosine * p);
  return s;
}

// The search cuts the near side at every turning point: of other text than what kernels follow.
TEST(HalfPlanes, horns_are_those_of_the_general_search) {
  constexpr double kDifference = 1e-8;  // of the reach
  constexpr double kApart = 1e-6;       // of the radius: nearer, rounding decides
  Random random(12);
  int planes = 0;
  for (int k = 0; k < 800; ++k) {
    const auto all = test::situations_of_one_horizon(random, 256, false);
    const Horizon horizon = test::horizon_of(all);
    for (const Situation& any : all) {
      const Situation s = random.below(2) == 0 ? close_pass(random, any) : any;
      if (norm(s.pair.position) < (1.0 + kApart) * s.pair.radius) continue;
      const Vec2 p = s.pair.position, v = s.pair.velocity;
      const auto frame = scalar::frame_of<scalar::Pack<double>>(
          {p.x, p.y}, {v.x, v.y}, s.pair.radius, s.reach, horizon.end());
      if (frame.on_collision_course.bit || scalar::tip(frame.local, horizon.end()).nearest.bit) {
        continue;
      }
      const RelativeHalfPlane plane = half_plane(s.pair, s.reach, horizon);
      if (plane.state != PairState::constrained) continue;
      const RelativeHalfPlane judge = searched_half_plane(s.pair, s.reach, horizon);
      ASSERT_EQ(plane.state, judge.state) << s;
      ASSERT_NEAR(plane.plane.offset, judge.plane.offset, kDifference * s.reach) << s;
      ++planes;
    }
  }
  EXPECT_GT(planes, 10'000);
}

// A pair's answer does not depend on the company that it is in.
TEST(HalfPlanes, order_does_not_matter) {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    std::vector<Situation> all = test::situations_of_one_horizon(random, 200, false);
    const Horizon horizon = test::horizon_of(all);
    Batch batch, reversed;
    batch.solve(all, horizon);
    std::reverse(all.begin(), all.end());
    reversed.solve(all, horizon);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_TRUE(same_bits(batch[i], reversed[all.size() - 1 - i])) << all[i];
    }
  }
}

}  // namespace
}  // namespace avo
