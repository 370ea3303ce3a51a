// SPDX-License-Identifier: Apache-2.0
#include "figures/contour.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace avo::figures {
namespace {

// Positive where the interior lies to the left.
double area(const std::vector<std::vector<Vec2>>& polygons) {
  double sum = 0.0;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      sum += 0.5 * cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  return sum;
}

constexpr Box kBox{{-3.0, -2.0}, {3.0, 2.0}};

TEST(Contour, a_disc_has_its_area_and_its_radius) {
  const auto f = [](Vec2 u) { return norm(u - Vec2{0.3, 0.1}) - 1.2; };
  const auto polygons = negative_set(kBox, 120, f, 1.0);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_NEAR(area(polygons), std::numbers::pi * 1.44, 0.003);
  for (const Vec2 vertex : polygons[0]) EXPECT_NEAR(f(vertex), 0.0, 6.0 / 120 * 0.05);
}

TEST(Contour, a_hole_turns_the_other_way) {
  const auto f = [](Vec2 u) { return std::fabs(norm(u) - 1.0) - 0.4; };
  const auto polygons = negative_set(kBox, 120, f, 1.0);
  ASSERT_EQ(polygons.size(), 2U);
  EXPECT_NEAR(area(polygons), std::numbers::pi * (1.4 * 1.4 - 0.36), 0.01);
}

TEST(Contour, a_set_that_leaves_the_box_ends_at_its_edge) {
  const auto half_plane = [](Vec2 u) { return u.x - 1.0; };
  const auto polygons = negative_set(kBox, 60, half_plane, 1.0);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_NEAR(area(polygons), 16.0, 1e-9);
  const auto all = negative_set(
      kBox, 60, [](Vec2) { return -1.0; }, 0.0);
  EXPECT_NEAR(area(all), 24.0, 1e-9);
  EXPECT_TRUE(negative_set(
                  kBox, 60, [](Vec2) { return 1.0; }, 0.0)
                  .empty());
}

TEST(Contour, skipped_regions_change_nothing) {
  int evaluations = 0;
  const auto f = [&evaluations](Vec2 u) {
    ++evaluations;
    const double first = norm(u - Vec2{1.0, 0.5}) - 0.7;
    const double second = norm(u - Vec2{-1.0, -0.5}) - 0.11;
    return std::fmin(first, second);
  };
  const auto fast = negative_set(kBox, 150, f, 1.0);
  const int few = evaluations;
  evaluations = 0;
  const auto full = negative_set(kBox, 150, f, std::numeric_limits<double>::infinity());
  EXPECT_LT(few, evaluations / 3);
  ASSERT_EQ(fast.size(), full.size());
  for (std::size_t i = 0; i < fast.size(); ++i) EXPECT_EQ(fast[i], full[i]);
}

TEST(Contour, touching_corners_stay_closed_polygons) {
  // a saddle in nearly every cell
  const auto f = [](Vec2 u) { return std::sin(20.0 * u.x) * std::sin(20.0 * u.y) + 0.01; };
  const auto polygons = negative_set(kBox, 57, f, 30.0);
  double sum = 0.0;
  for (const auto& polygon : polygons) {
    EXPECT_GE(polygon.size(), 3U);
    sum += area({polygon});
  }
  EXPECT_GT(sum, 8.0);
  EXPECT_LT(sum, 14.0);
}

}  // namespace
}  // namespace avo::figures
