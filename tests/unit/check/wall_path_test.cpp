// SPDX-License-Identifier: Apache-2.0
// Nearest instants and crossings of a cubic and a segment against dense sampling in long double.
#include "check/wall_path.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "sampled.h"
#include "support/generators.h"

namespace avo::judge {
namespace {

using test::Random;

Real sampled_distance(const WallPath& path, Real u) {
  const auto [x, y] = place_at(path.from_start, u);
  const Real dx = static_cast<Real>(path.segment.x), dy = static_cast<Real>(path.segment.y);
  const Real squared = dx * dx + dy * dy;
  const Real along = squared > 0 ? std::clamp<Real>((x * dx + y * dy) / squared, 0, 1) : 0;
  return std::hypot(x - along * dx, y - along * dy);
}

Real sampled_least(const WallPath& path) {
  return least_by_samples([&](Real u) { return sampled_distance(path, u); });
}

double size_of(const WallPath& path) {
  double size = 0.0;
  for (const Vec2 point : path.from_start.control)
    size = std::max({size, norm(point), norm(point - path.segment)});
  return size;
}

// The distance is attained where it is said to be, and no sample is nearer.
double expect_nearest(const WallPath& path) {
  const Instant nearest = nearest_instant(path);
  const double tolerance = 1e-13 * size_of(path);
  EXPECT_LE(nearest.distance, static_cast<double>(sampled_least(path)) + tolerance);
  EXPECT_NEAR(static_cast<double>(sampled_distance(path, nearest.fraction)), nearest.distance,
              tolerance);
  EXPECT_NEAR(distance_at(path, nearest.fraction), nearest.distance, tolerance);
  EXPECT_LE(lower_bound(path), nearest.distance + tolerance);
  return nearest.distance;
}

WallPath random_path(Random& random, double size, double wall) {
  WallPath path;
  for (Vec2& point : path.from_start.control) point = test::in_disc(random, size);
  path.segment = wall * random.direction();
  const Vec2 start = test::in_disc(random, size);
  for (Vec2& point : path.from_start.control) point = point - start;
  return path;
}

TEST(WallPath, nearest_agrees_with_dense_sampling) {
  Random random(11);
  int crossed = 0, ends = 0, beside = 0;
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const double size = random.log_uniform(1e-9, 1e9);
    const WallPath path = random_path(random, size, size * random.log_uniform(1e-6, 1e3));
    const double distance = expect_nearest(path);
    RelativePath from_end = path.from_start;
    for (Vec2& point : from_end.control) point = point - path.segment;
    const double of_ends =
        std::min(nearest_instant(path.from_start).distance, nearest_instant(from_end).distance);
    if (distance < 1e-12 * size)
      ++crossed;
    else if (distance < of_ends)
      ++beside;
    else
      ++ends;
  }
  EXPECT_GT(crossed, 200);
  EXPECT_GT(beside, 200);
  EXPECT_GT(ends, 200);
}

// Along a wall, with turns that hardly touch the distance: wiggles down to the last bits.
TEST(WallPath, nearest_where_the_distance_hardly_changes) {
  Random random(12);
  for (int k = 0; k < 2'000 && !HasFailure(); ++k) {
    WallPath path;
    const Vec2 along = random.direction(), across = perpendicular(along);
    const double off = random.uniform(-1.0, 1.0);
    for (std::size_t i = 0; i < 4; ++i)
      path.from_start.control[i] =
          (random.uniform(0.0, 3.0)) * along + (off + random.near_zero()) * across;
    path.segment = random.uniform(0.5, 4.0) * along;
    expect_nearest(path);
  }
}

TEST(WallPath, a_point_is_a_segment_without_length) {
  Random random(13);
  for (int k = 0; k < 500 && !HasFailure(); ++k) {
    const WallPath path = random_path(random, 1.0, 0.0);
    EXPECT_EQ(expect_nearest(path), nearest_instant(path.from_start).distance);
    EXPECT_EQ(first_below(path, 0.3), first_below(path.from_start, 0.3));
  }
}

// From 1 m beside the middle to 1 m beside it, 0.25 m away in between: y = 1 - 3 u (1 - u).
TEST(WallPath, a_grazing_pass_between_the_ends) {
  const RelativePath pass{{{{0.5, 1.0}, {0.5, 0.0}, {0.5, 0.0}, {0.5, 1.0}}}};
  const WallPath wall{pass, {1.0, 0.0}};
  EXPECT_EQ(distance_at(wall, 0.0), 1.0);
  EXPECT_NEAR(nearest_instant(wall).distance, 0.25, 1e-15);
  EXPECT_NEAR(nearest_instant(wall).fraction, 0.5, 1e-12);
  EXPECT_EQ(first_below(wall, 0.25), std::nullopt);
  // 1 - 3 u (1 - u) = 0.3
  EXPECT_NEAR(*first_below(wall, 0.3), 0.5 - std::sqrt(0.25 - 0.7 / 3.0), 1e-14);
}

TEST(WallPath, crossings_agree_with_dense_sampling) {
  constexpr int kSamples = 2'000;
  Random random(14);
  int crossings = 0;
  for (int k = 0; k < 1'000 && !HasFailure(); ++k) {
    const WallPath path = random_path(random, 1.0, random.uniform(0.1, 2.0));
    const double limit = random.uniform(0.01, 0.5);
    int first = -1;
    for (int i = 0; i <= kSamples && first < 0; ++i)
      if (sampled_distance(path, static_cast<Real>(i) / kSamples) < limit) first = i;
    const auto below = first_below(path, limit);
    if (first < 0) {
      if (below) {
        EXPECT_GT(sampled_least(path), limit - 1e-5) << "between two samples";
      }
      continue;
    }
    ASSERT_TRUE(below.has_value());
    EXPECT_LE(*below, static_cast<double>(first) / kSamples);
    if (*below > 0.0) {
      ++crossings;
      EXPECT_NEAR(static_cast<double>(sampled_distance(path, *below)), limit, 1e-13);
    }
  }
  EXPECT_GT(crossings, 200);
}

}  // namespace
}  // namespace avo::judge
