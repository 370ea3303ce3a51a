// SPDX-License-Identifier: Apache-2.0
// Nearest instants and crossings of a cubic against dense sampling in long double.
#include "check/relative_path.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "sampled.h"
#include "support/generators.h"

namespace avo::judge {
namespace {

using test::Random;

Real distance_at(const RelativePath& path, Real u) {
  const Place at = place_at(path, u);
  return std::sqrt(at.x * at.x + at.y * at.y);
}

Real sampled_least(const RelativePath& path) {
  return least_by_samples([&](Real u) { return distance_at(path, u); });
}

double size_of(const RelativePath& path) {
  double size = 0.0;
  for (const Vec2 point : path.control) size = std::max(size, norm(point));
  return size;
}

// The distance found is attained where it is said to be, and no sample is nearer.
void expect_nearest(const RelativePath& path) {
  const Instant found = nearest_instant(path);
  const double tolerance = 1e-13 * size_of(path);
  const Real expected = sampled_least(path);
  EXPECT_LE(found.distance, static_cast<double>(expected) + tolerance);
  EXPECT_NEAR(static_cast<double>(distance_at(path, found.fraction)), found.distance, tolerance);
  EXPECT_LE(lower_bound(path), found.distance + tolerance);
}

RelativePath random_path(Random& random, double size) {
  RelativePath path;
  for (Vec2& point : path.control) point = test::in_disc(random, size);
  return path;
}

TEST(RelativePath, nearest_agrees_with_dense_sampling) {
  Random random(1);
  for (int k = 0; k < 2'000 && !HasFailure(); ++k)
    expect_nearest(random_path(random, random.log_uniform(1e-9, 1e12)));
}

// The path from p_0 to p_3 that passes the origin, or nearly: control points from a cubic in
// powers.
TEST(RelativePath, nearest_where_bodies_nearly_coincide) {
  Random random(2);
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    RelativePath path = random_path(random, 1.0);
    const double u = random.uniform(0.0, 1.0);
    const Vec2 miss = random.near_zero() * random.direction();
    const auto& c = path.control;
    const double q = 1.0 - u;
    const Vec2 there =
        (q * q * q) * c[0] + (3 * q * q * u) * c[1] + (3 * q * u * u) * c[2] + (u * u * u) * c[3];
    for (Vec2& point : path.control) point = point - there + miss;
    expect_nearest(path);
    EXPECT_LE(nearest_instant(path).distance, norm(miss) + 1e-13);
  }
}

// Arcs about the origin: the distance hardly changes, down to the last bits. Also a test that the
// isolation ends.
TEST(RelativePath, nearest_where_the_distance_hardly_changes) {
  Random random(3);
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const double angle = random.log_uniform(1e-12, 3.0), handle = 4.0 / 3.0 * std::tan(angle / 4.0);
    const Vec2 end{std::cos(angle), std::sin(angle)};
    const double off = 1.0 + random.near_zero();
    const double grow = 1.0 + 1e-3 * random.near_zero();
    expect_nearest(
        {{{{1.0, 0.0}, {off, handle}, end - (off * handle) * perpendicular(end), grow * end}}});
  }
}

// Two equal minima, the path mirrored in the x axis; a cusp; a loop.
TEST(RelativePath, nearest_of_two_equal_minima_is_the_first) {
  const RelativePath path{{{{2.0, -1.0}, {-3.0, -0.5}, {-3.0, 0.5}, {2.0, 1.0}}}};
  expect_nearest(path);
  EXPECT_LT(nearest_instant(path).fraction, 0.5);
  expect_nearest({{{{1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}}}});
  expect_nearest({{{{-1.0, 0.1}, {2.0, 1.5}, {-2.0, 1.5}, {1.0, 0.1}}}});
}

TEST(RelativePath, bodies_that_keep_their_distance) {
  const RelativePath still{{{{3.0, 4.0}, {3.0, 4.0}, {3.0, 4.0}, {3.0, 4.0}}}};
  EXPECT_EQ(nearest_instant(still).distance, 5.0);
  EXPECT_EQ(nearest_instant(still).fraction, 0.0);
  EXPECT_EQ(nearest_instant(RelativePath{}).distance, 0.0);
  EXPECT_EQ(first_below(still, 5.0), std::nullopt) << "not less";
  EXPECT_EQ(first_below(still, std::nextafter(5.0, 6.0)), 0.0);
  EXPECT_EQ(last_below(still, std::nextafter(5.0, 6.0)), 1.0);
  EXPECT_EQ(first_below({}, 0.0), std::nullopt);
}

TEST(RelativePath, a_fast_pass_between_the_ends) {
  for (const double miss : {0.0, 1e-9, 0.3, 0.9}) {
    const RelativePath pass{{{{-10.0, miss}, {-10.0 / 3, miss}, {10.0 / 3, miss}, {10.0, miss}}}};
    const Instant nearest = nearest_instant(pass);
    EXPECT_NEAR(nearest.distance, miss, 1e-14);
    EXPECT_NEAR(nearest.fraction, 0.5, 1e-15);
    const double half = std::sqrt(1.0 - miss * miss) / 20.0;
    EXPECT_NEAR(*first_below(pass, 1.0), 0.5 - half, 1e-14);
    EXPECT_NEAR(*last_below(pass, 1.0), 0.5 + half, 1e-14);
  }
}

TEST(RelativePath, crossings_agree_with_dense_sampling) {
  constexpr int kSamples = 2'000;
  Random random(4);
  int crossings = 0;
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    const RelativePath path = random_path(random, 1.0);
    const double limit = random.uniform(0.05, 0.8);
    int first = -1, last = -1;
    for (int i = 0; i <= kSamples; ++i) {
      if (!(distance_at(path, static_cast<Real>(i) / kSamples) < limit)) continue;
      if (first < 0) first = i;
      last = i;
    }
    const auto found = first_below(path, limit), left = last_below(path, limit);
    ASSERT_EQ(found.has_value(), left.has_value());
    if (first < 0) {
      if (found) {
        EXPECT_GT(sampled_least(path), limit - 1e-5) << "between two samples";
      }
      continue;
    }
    ASSERT_TRUE(found.has_value());
    EXPECT_LE(*found, static_cast<double>(first) / kSamples);
    EXPECT_GE(*left, static_cast<double>(last) / kSamples);
    for (const double u : {*found, *left}) {
      if (u > 0.0 && u < 1.0) {
        ++crossings;
        EXPECT_NEAR(static_cast<double>(distance_at(path, u)), limit, 1e-14);
      }
    }
    // nothing nearer than the limit before the first and after the last
    for (int i = 0; i <= kSamples; ++i) {
      const double u = static_cast<double>(i) / kSamples;
      if (u < *found - 1e-14 || u > *left + 1e-14) {
        EXPECT_GE(distance_at(path, u), limit);
      }
    }
  }
  EXPECT_GT(crossings, 500);
}

}  // namespace
}  // namespace avo::judge
