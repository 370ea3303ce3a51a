// SPDX-License-Identifier: Apache-2.0
// The sets of the paper's §III in cases that can be worked out by hand.
#include "avo/velocity_obstacle.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace avo {
namespace {

constexpr double kNear = 1e-14;

// Eqs. (4)-(6): at (-4, 0), r = 1, for 2 s: a cone of half-angle asin(1/4), cut off at speed 1.5.
const Obstacle kPlain{{{-4.0, 0.0}, {0.3, -0.2}, 1.0}, Response::velocity(), 2.0};

TEST(VelocityObstacle, contains_what_collides_in_time) {
  EXPECT_TRUE(contains(kPlain, {2.0, 0.0}));
  EXPECT_TRUE(contains(kPlain, {1.6, 0.0}));
  EXPECT_FALSE(contains(kPlain, {1.5, 0.0}));  // touches at τ: the set is open
  EXPECT_FALSE(contains(kPlain, {1.4, 0.0}));
  EXPECT_FALSE(contains(kPlain, {-2.0, 0.0}));
  const double tangent = 1.0 / std::sqrt(15.0);
  EXPECT_TRUE(contains(kPlain, {3.0, 3.0 * tangent * 0.999}));
  EXPECT_FALSE(contains(kPlain, {3.0, 3.0 * tangent * 1.001}));
}

TEST(VelocityObstacle, disc_is_minus_p_over_t) {
  const Disc found = disc(kPlain, 2.0);
  EXPECT_NEAR(found.center.x, 2.0, kNear);
  EXPECT_NEAR(found.center.y, 0.0, kNear);
  EXPECT_NEAR(found.radius, 0.5, kNear);
}

TEST(VelocityObstacle, boundary_is_two_rays_and_an_arc) {
  const Boundary found = boundary(kPlain, 4);
  ASSERT_EQ(found.left.size(), 4U);
  ASSERT_EQ(found.right.size(), 4U);
  const double slope = 1.0 / std::sqrt(15.0);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(found.left[k].y, slope * found.left[k].x, kNear);
    EXPECT_NEAR(found.right[k].y, -slope * found.right[k].x, kNear);
  }
  EXPECT_LT(norm(found.left[0]), norm(found.left[1]));  // from τ backwards: outwards
  ASSERT_GE(found.cap.size(), 3U);
  EXPECT_EQ(found.cap.front(), found.left.front());
  EXPECT_EQ(found.cap.back(), found.right.front());
  double nearest = 10.0;
  for (const Vec2 u : found.cap) {
    EXPECT_NEAR(norm(u - Vec2{2.0, 0.0}), 0.5, kNear);
    nearest = std::min(nearest, norm(u));
  }
  EXPECT_NEAR(nearest, 1.5, kNear);  // the arc faces the origin
}

// §III-B: from rest at (-4, 0), r = 1: in 2 s an acceleration of 1.5 just touches.
TEST(AccelerationObstacle, contains_what_collides_in_time) {
  const Obstacle obstacle{{{-4.0, 0.0}, {0.0, 0.0}, 1.0}, Response::acceleration(), 2.0};
  EXPECT_TRUE(contains(obstacle, {1.51, 0.0}));
  EXPECT_FALSE(contains(obstacle, {1.49, 0.0}));
  EXPECT_FALSE(contains(obstacle, {-2.0, 0.0}));
  EXPECT_EQ(disc(obstacle, 2.0).center, (Vec2{2.0, 0.0}));
}

// Eq. (10) with δ = 1: g(1) = 1/e, so that w = 3 e is what goes 3 m in 1 s.
TEST(AccelerationVelocityObstacle, contains_what_collides_in_time) {
  const Obstacle obstacle{{{-4.0, 0.0}, {0.0, 0.0}, 1.0}, Response::proportional(1.0), 1.0};
  const double touching = 3.0 * std::exp(1.0);
  EXPECT_TRUE(contains(obstacle, {touching * 1.0001, 0.0}));
  EXPECT_FALSE(contains(obstacle, {touching * 0.9999, 0.0}));
}

TEST(ClosestApproach, at_rest_is_now) {
  const Obstacle obstacle{{{3.0, 4.0}, {0.0, 0.0}, 1.0}, Response::proportional(4.0), 10.0};
  const ClosestApproach found = closest_approach(obstacle, {0.0, 0.0});
  EXPECT_EQ(found.time, 0.0);
  EXPECT_EQ(found.distance, 5.0);
}

TEST(ClosestApproach, straight_line_passes_at_its_foot) {
  const Obstacle obstacle{{{-4.0, 1.0}, {0.0, 0.0}, 1.0}, Response::velocity(), 10.0};
  const ClosestApproach found = closest_approach(obstacle, {2.0, 0.0});
  EXPECT_NEAR(found.time, 2.0, kNear);
  EXPECT_NEAR(found.distance, 1.0, kNear);
}

TEST(ClosestApproach, still_closing_is_the_end_of_the_window) {
  const Obstacle obstacle{{{-4.0, 0.0}, {1.0, 0.0}, 1.0}, Response::proportional(1.0), 0.5};
  const ClosestApproach found = closest_approach(obstacle, {1.0, 0.0});
  EXPECT_EQ(found.time, 0.5);
  EXPECT_EQ(found.distance, 3.5);
}

// x = -1 + 4t - t^2 and back over the same point, y constant: both passes are equally near.
TEST(ClosestApproach, of_two_equal_passes_the_first) {
  const Obstacle obstacle{{{-3.0, 0.5}, {4.0, 0.0}, 0.1}, Response::acceleration(), 10.0};
  const ClosestApproach found = closest_approach(obstacle, {-2.0, 0.0});
  EXPECT_NEAR(found.time, 1.0, 1e-12);
  EXPECT_NEAR(found.distance, 0.5, kNear);
}

// The obstacle comes in, turns at distance 1 and leaves again along the same line.
TEST(ClosestApproach, reversal_is_found) {
  const Obstacle obstacle{{{5.0, 0.0}, {-4.0, 0.0}, 0.5}, Response::acceleration(), 10.0};
  const ClosestApproach found = closest_approach(obstacle, {2.0, 0.0});
  EXPECT_NEAR(found.time, 2.0, 1e-7);  // where the distance is flat
  EXPECT_NEAR(found.distance, 1.0, kNear);
}

// Centers meet exactly: the distance must come out as 0, not as the square root of rounding.
TEST(ClosestApproach, head_on_reaches_zero) {
  const Obstacle obstacle{{{-6.0, 0.0}, {2.0, 0.0}, 1.0}, Response::proportional(4.0), 10.0};
  const ClosestApproach found = closest_approach(obstacle, {2.0, 0.0});
  EXPECT_NEAR(found.time, 3.0, 1e-14);
  EXPECT_LE(found.distance, 1e-15);
}

// A first pass at 1 m after 1 s and a second, nearer one at the end of a long window.
TEST(ClosestApproach, later_and_nearer_pass_is_not_missed) {
  const Obstacle obstacle{{{-3.0, 1.0}, {4.0, -0.01}, 0.1}, Response::acceleration(), 10.0};
  const ClosestApproach found = closest_approach(obstacle, {-2.0, 0.0});
  EXPECT_GT(found.time, 2.9);
  EXPECT_NEAR(found.distance, 0.97, 1e-4);
}

TEST(ClosestApproach, contact_that_parts_is_not_contained) {
  const Obstacle obstacle{{{1.0, 0.0}, {0.5, 0.0}, 1.0}, Response::proportional(4.0), 10.0};
  EXPECT_EQ(closest_approach(obstacle, {0.5, 0.0}).distance, 1.0);
  EXPECT_FALSE(contains(obstacle, {0.5, 0.0}));
  EXPECT_TRUE(contains(obstacle, {-0.5, 0.0}));
}

TEST(ClosestApproach, contains_agrees_with_the_distance) {
  Obstacle obstacle{{{-4.0, 1.0}, {0.0, 0.0}, 1.001}, Response::velocity(), 10.0};
  EXPECT_TRUE(contains(obstacle, {2.0, 0.0}));
  obstacle.pair.radius = 0.999;
  EXPECT_FALSE(contains(obstacle, {2.0, 0.0}));
}

TEST(TangentPoints, are_left_then_right_seen_from_the_origin) {
  const auto [left, right] = tangent_points({{5.0, 0.0}, 3.0});
  EXPECT_NEAR(left.x, 3.2, kNear);
  EXPECT_NEAR(left.y, 2.4, kNear);
  EXPECT_NEAR(right.x, 3.2, kNear);
  EXPECT_NEAR(right.y, -2.4, kNear);
}

TEST(TangentPoints, inside_the_disc_there_are_none) {
  const auto [left, right] = tangent_points({{0.5, 0.25}, 1.0});
  EXPECT_EQ(left, (Vec2{0.5, 0.25}));
  EXPECT_EQ(right, (Vec2{0.5, 0.25}));
}

// Closing fast from near contact, p + s v dips into the disc of radius r: those times have no
// tangent, since each disc lies in the one before.
TEST(Boundary, nested_discs_are_left_out) {
  const Obstacle obstacle{{{1.1, 0.0}, {-1.0, 0.0}, 1.0}, Response::proportional(4.0), 10.0};
  const Boundary found = boundary(obstacle, 50);
  EXPECT_GT(found.left.size(), 0U);
  EXPECT_LT(found.left.size(), 50U);
  EXPECT_EQ(found.left.size(), found.right.size());
  for (std::size_t k = 0; k < found.left.size(); ++k) {
    EXPECT_TRUE(is_finite(found.left[k]) && is_finite(found.right[k]));
  }
}

}  // namespace
}  // namespace avo
