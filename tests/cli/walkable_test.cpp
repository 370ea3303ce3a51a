// SPDX-License-Identifier: Apache-2.0
// The rings around what obstacles leave free, where these touch, cross and hold each other.
#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>
#include <numeric>
#include <vector>

#include "avo/error.h"
#include "io/export/rings.h"
#include "io/maps/wall_space.h"

namespace avo_test {
namespace {

using avo::Vec2;
using avo_io::FreePart;
using avo_io::Ring;
using Regions = std::vector<avo::StaticObstacle>;

avo::StaticObstacle polygon(std::vector<Vec2> points, avo::Fill fill = avo::Fill::solid) {
  return {{{std::move(points), true}}, 0.0, fill};
}

avo::StaticObstacle box(Vec2 min, Vec2 max, avo::Fill fill = avo::Fill::solid) {
  return polygon({min, {max.x, min.y}, max, {min.x, max.y}}, fill);
}

double area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    twice += cross(ring[k], ring[(k + 1) % ring.size()]);
  return twice / 2.0;
}

double area(const FreePart& part) {
  return std::accumulate(part.holes.begin(), part.holes.end(), area(part.outer),
                         [](double sum, const Ring& hole) { return sum + area(hole); });
}

/// With bounds from (0, 0) to (10, 10).
std::vector<FreePart> parts(Regions regions) {
  regions.push_back(box({0, 0}, {10, 10}, avo::Fill::bounds));
  return avo_io::free_parts(regions);
}

// No ring comes by a point twice, which is what makes text valid where obstacles touch in points.
void expect_simple(const std::vector<FreePart>& all) {
  for (const FreePart& part : all) {
    std::vector<Ring> rings = part.holes;
    rings.push_back(part.outer);
    EXPECT_GT(area(part.outer), 0.0);
    for (const Ring& hole : part.holes) EXPECT_LT(area(hole), 0.0);
    for (const Ring& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(ring[i] == ring[k]);
  }
}

TEST(Walkable, solids_inside_are_holes) {
  const auto found = parts({box({1, 1}, {2, 2}), box({4, 4}, {7, 6})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].holes.size(), 2U);
  EXPECT_DOUBLE_EQ(area(found[0]), 100.0 - 1.0 - 6.0);
  EXPECT_EQ(found[0].outer.size(), 4U);
  expect_simple(found);
}

TEST(Walkable, solids_that_cross_share_borders_or_corners_are_one) {
  const auto crossing = parts({box({1, 4}, {9, 6}), box({4, 1}, {6, 9})});
  ASSERT_EQ(crossing[0].holes.size(), 1U);
  EXPECT_EQ(crossing[0].holes[0].size(), 12U);
  EXPECT_DOUBLE_EQ(area(crossing[0]), 100.0 - 16.0 - 12.0);
  const auto beside = parts({box({1, 1}, {2, 2}), box({2, 1}, {3, 2}), box({2, 1.5}, {4, 3})});
  ASSERT_EQ(beside[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(area(beside[0]), 100.0 - 2.0 - 3.0 + 0.5);
  const auto corners = parts({box({1, 1}, {2, 2}), box({2, 2}, {3, 3})});
  ASSERT_EQ(corners[0].holes.size(), 2U) << "each a ring of its own";
  EXPECT_DOUBLE_EQ(area(corners[0]), 98.0);
  for (const auto& all : {crossing, beside, corners}) expect_simple(all);
}

TEST(Walkable, the_same_solid_twice_counts_once) {
  const auto found = parts({box({1, 1}, {3, 3}), box({1, 1}, {3, 3}), box({1.5, 1.5}, {2, 2})});
  ASSERT_EQ(found[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(area(found[0]), 96.0);
}

TEST(Walkable, walls_from_side_to_side_make_two_parts) {
  const auto found = parts({box({3, -1}, {4, 11})});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_DOUBLE_EQ(area(found[0]), 30.0) << "smallest first";
  EXPECT_DOUBLE_EQ(area(found[1]), 60.0);
  const auto touching = parts({polygon({{5, 0}, {10, 5}, {5, 10}, {0, 5}})});
  EXPECT_EQ(touching.size(), 4U) << "corners of a square around a diamond";
  expect_simple(touching);
}

TEST(Walkable, rooms_in_solids_are_parts_of_their_own) {
  avo::StaticObstacle frame = box({1, 1}, {9, 9});
  frame.chains.push_back(box({3, 3}, {7, 7}).chains[0]);  // inside of the hole is outside
  const auto found = parts({frame, box({4, 4}, {5, 5})});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_DOUBLE_EQ(area(found[0]), 15.0);
  EXPECT_EQ(found[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(area(found[1]), 36.0);
  EXPECT_EQ(found[1].holes.size(), 1U);
}

TEST(Walkable, several_bounds_leave_what_is_in_all_of_them) {
  const auto found = parts({box({5, -5}, {15, 5}, avo::Fill::bounds)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].outer.size(), 4U);
  EXPECT_DOUBLE_EQ(area(found[0]), 25.0);
  EXPECT_EQ(parts({box({20, 20}, {30, 30}, avo::Fill::bounds)}).size(), 0U);
}

// Slanted ones, by a second, slow count: points of a lattice.
TEST(Walkable, many_slanted_solids_cover_as_many_points) {
  Regions regions;
  for (int k = 0; k < 40; ++k) {
    const double x = 0.37 * k - 2.0, y = std::fmod(2.71 * k, 10.0), a = 0.3 + 0.05 * (k % 17);
    regions.push_back(polygon({{x, y}, {x + a, y + 0.7 * a}, {x + 0.2, y + 1.3 * a}}));
  }
  const auto found = parts(regions);
  expect_simple(found);
  regions.push_back(box({0, 0}, {10, 10}, avo::Fill::bounds));
  const avo_io::Regions slow(regions);
  std::size_t count = 0;
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < 200; ++k) {
      const Vec2 p{0.05 * i + 0.0243, 0.05 * k + 0.0251};
      std::size_t inside = 0;
      for (const FreePart& part : found) {
        inside += avo_io::is_inside(part.outer, p) ? 1U : 0U;
        for (const Ring& hole : part.holes) inside -= avo_io::is_inside(hole, p) ? 1U : 0U;
      }
      EXPECT_EQ(inside, slow.allow(p) ? 1U : 0U) << p.x << " " << p.y;
      count += inside;
    }
  }
  EXPECT_GT(count, 20000U);
  EXPECT_LT(count, 39000U);
}

TEST(Walkable, far_from_the_origin_digits_are_fewer) {
  for (const double at : {1e3, 1e6, 1e9, 1e12}) {
    const double side = at * 1e-3;
    const auto found =
        avo_io::free_parts(Regions{box({at, at}, {at + 3 * side, at + 3 * side}, avo::Fill::bounds),
                                   box({at + side, at + side}, {at + 2 * side, at + 2 * side})});
    ASSERT_EQ(found.size(), 1U) << at;
    ASSERT_EQ(found[0].holes.size(), 1U);
    EXPECT_NEAR(found[0].outer[0].x, at, 1e-9 * at);
  }
}

}  // namespace
}  // namespace avo_test
