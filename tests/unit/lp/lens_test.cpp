// SPDX-License-Identifier: Apache-2.0
// The intersection of two discs: support and projection against dense samples of its boundary.
#include "lp/lens.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "unit/lp/brute_force.h"

namespace avo::test {
namespace {

// Least normal . u over samples of both circles that lie in both discs.
double sampled_min(Vec2 normal, const Disc& a, const Disc& b, int samples) {
  double least = std::numeric_limits<double>::infinity();
  for (const Disc& disc : {a, b}) {
    for (int k = 0; k < samples; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / samples;
      const Vec2 u = disc.center + disc.radius * Vec2{std::cos(angle), std::sin(angle)};
      if (norm(u - a.center) > a.radius * (1 + 1e-12)) continue;
      if (norm(u - b.center) > b.radius * (1 + 1e-12)) continue;
      least = std::min(least, dot(normal, u));
    }
  }
  return least;
}

// The discs may lie anywhere. The second disc is the speed disc, which lies around 0.
double support_min(Vec2 normal, const Disc& a, const Disc& b) {
  const Lens lens = make_lens({a.center - b.center, a.radius}, b.radius);
  return lens_support_min(normal, lens) + dot(normal, b.center);
}

TEST(Lens, support_agrees_with_samples_and_is_never_above_them) {
  Random random(11);
  int crossing = 0;
  for (int k = 0; k < 2000; ++k) {
    const Disc a{random.in_square(1.0), random.uniform(0.3, 2.0)};
    const Disc b{random.in_square(1.0), random.uniform(0.3, 2.0)};
    const Vec2 normal = random.unit();
    const double exact = support_min(normal, a, b);
    const double sampled = sampled_min(normal, a, b, 3000);
    if (!std::isfinite(sampled)) continue;  // disjoint, or too thin for the samples
    crossing += norm(a.center - b.center) > std::abs(a.radius - b.radius) ? 1 : 0;
    EXPECT_LE(exact, sampled + 1e-14);
    EXPECT_GE(exact, sampled - 0.01);  // samples are up to 2 π 2 / 3000 off the corners
    EXPECT_NEAR(exact, support_min(normal, b, a), 1e-14);
  }
  EXPECT_GT(crossing, 500);
}

TEST(Lens, support_of_a_nested_disc_is_its_own) {
  EXPECT_EQ(support_min({1, 0}, Disc{{0, 0}, 1}, Disc{{0, 0}, 4}), -1.0);
  EXPECT_EQ(
      support_min({0, -1}, Disc{{0, 3}, std::numeric_limits<double>::infinity()}, Disc{{0, 0}, 2}),
      -2.0);
}

TEST(Lens, support_at_a_corner) {
  EXPECT_NEAR(support_min({0, 1}, Disc{{0, 0}, 1}, Disc{{1, 0}, 1}), -std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(support_min({0, -1}, Disc{{0, 0}, 1}, Disc{{1, 0}, 1}), -std::sqrt(0.75), 1e-15);
}

TEST(Lens, nothing_is_below_the_support_of_nothing) {
  EXPECT_EQ(support_min({1, 0}, Disc{{0, 0}, 1}, Disc{{5, 0}, 1}),
            std::numeric_limits<double>::infinity());
}

TEST(Lens, nearly_equal_discs_do_not_jump_to_a_corner) {
  // Centers and radii off by an ulp: "outside of both circles" by rounding alone sent the answer
  // to a corner a quarter turn away, and the worst violation from 0.005 to 0.2.
  const Disc a{{0.50000000000000022, -1.0000000000000004}, 1.75};
  const Disc b{{0.50000000000000033, -1}, 1.7499999999999998};
  Random random(12);
  for (int k = 0; k < 2000; ++k) {
    const Vec2 n = random.unit();
    EXPECT_NEAR(support_min(n, a, b), dot(n, a.center) - 1.75, 4e-15);
  }
}

// The square of a distance may exceed the radius' square while the distance does not exceed the
// radius: "outside" by the one and "inside" by the other sent such points to a corner.
TEST(Lens, points_on_a_circle_stay_where_they_are) {
  Random random(13);
  const Vec2 center{1, 0};
  const Lens lens = make_lens({center, 1.25}, 1);
  for (int k = 0; k < 100000; ++k) {
    const Vec2 small = random.unit();
    const Vec2 large = center + 1.25 * random.unit();
    for (Vec2 p : {small, large}) {
      if (norm(p) > 1 + 1e-12 || norm(p - center) > 1.25 + 1e-12) continue;
      ASSERT_LE(norm(nearest(lens, p) - p), 4e-15);
    }
  }
}

}  // namespace
}  // namespace avo::test
