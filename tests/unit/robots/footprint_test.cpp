// SPDX-License-Identifier: Apache-2.0
// Covers of rectangles and polygons by discs in a row.
#include "avo/footprint.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/discs.h"
#include "avo/error.h"
#include "robots/model.h"
#include "support/generators.h"
#include "support/refusal.h"

namespace avo::test {
namespace {

// m: how far the point is outside of the nearest disc.
double outside(const Footprint& footprint, Vec2 p) {
  double least = 1e9;
  for (int k = 0; k < footprint.discs; ++k)
    least = std::min(least, norm(p - Vec2{footprint.ahead(k), 0.0}) - footprint.radius);
  return least;
}

TEST(Footprint, of_a_truck_is_three_discs) {
  const Footprint truck = cover_rectangle(6.0, 2.0, 1.75, 0.5);
  EXPECT_EQ(truck.discs, 3);
  EXPECT_NEAR(truck.radius, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(truck.first, -0.25, 1e-15);
  EXPECT_NEAR(truck.spacing, 2.0, 1e-15);
  EXPECT_NEAR(bounding_radius(truck), 3.75 + std::sqrt(2.0), 1e-15);
}

TEST(Footprint, covers_all_of_a_rectangle_with_as_few_discs_as_the_excess_allows) {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const double width = random.log_uniform(0.1, 3.0), length = width * random.uniform(0.3, 5.0);
    const double offset = random.uniform(-2.0, 2.0), excess = width * random.uniform(0.25, 0.6);
    const Footprint cover = cover_rectangle(length, width, offset, excess);
    EXPECT_LE(cover.radius, 0.5 * width + excess);
    for (int k = 0; k < 50; ++k) {
      Vec2 p{offset + 0.5 * length * random.uniform(-1.0, 1.0),
             0.5 * width * random.uniform(-1.0, 1.0)};
      if (k % 3 == 0) p.y = std::copysign(0.5 * width, p.y);
      EXPECT_LE(outside(cover, p), 1e-12);
    }
    const double half = 0.5 * length / (cover.discs - 1);
    if (cover.discs > 1) {
      EXPECT_GT(norm(Vec2{half, 0.5 * width}), 0.5 * width + excess);
    }
  }
}

TEST(Footprint, covers_all_of_a_polygon) {
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Vec2> corners;
    const int count = 3 + random.below(5);
    for (int k = 0; k < count; ++k) {
      const double angle = 6.283 * (k + random.uniform(0.0, 0.9)) / count;
      const double reach = random.uniform(0.3, 1.0);
      corners.push_back({2.0 * reach * std::cos(angle) + 0.5, reach * std::sin(angle)});
    }
    const Footprint cover = cover_polygon(corners, 1.0);
    for (int k = 0; k < 50; ++k) {
      const std::size_t i = static_cast<std::size_t>(random.below(count));
      const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
      EXPECT_LE(outside(cover, a + random.uniform(0.0, 1.0) * (b - a)), 1e-12);
    }
  }
}

TEST(Footprint, of_a_rectangle_given_as_polygon_is_the_same) {
  const Footprint rectangle = cover_rectangle(4.0, 1.2, 0.5, 0.3);
  const std::vector<Vec2> corners{{-1.5, -0.6}, {2.5, -0.6}, {2.5, 0.6}, {-1.5, 0.6}};
  const Footprint polygon = cover_polygon(corners, 0.3);
  EXPECT_EQ(polygon.discs, rectangle.discs);
  EXPECT_NEAR(polygon.radius, rectangle.radius, 1e-14);
  EXPECT_NEAR(polygon.first, rectangle.first, 1e-14);
  EXPECT_NEAR(polygon.spacing, rectangle.spacing, 1e-14);
}

TEST(Footprint, is_refused_where_five_discs_exceed_it_by_more) {
  EXPECT_EQ(refusal([] { return cover_rectangle(16.5, 2.5, 0.0, 0.5); }),
            "excess: found 0.5 m, must be >= 0.8200241544484452 m: so far do 5 discs exceed the "
            "sides");
  EXPECT_EQ(refusal([] { return cover_rectangle(0.0, 2.5, 0.0, 0.5); }),
            "length: found 0, must be > 0 m");
  const std::vector<Vec2> two{{0, 0}, {1, 1}}, line{{0, 0}, {1, 0}, {2, 0}};
  EXPECT_EQ(refusal([&] { return cover_polygon(two, 0.5); }),
            "corners: found 2 corners, must be 3 or more");
  EXPECT_EQ(refusal([&] { return cover_polygon(line, 0.5); }),
            "corners: found a line, must be the corners of a polygon");
}

TEST(Footprint, of_a_drive_is_about_the_point_ahead) {
  DifferentialDrive drive{.offset = 0.4};
  drive.footprint = {3, 0.5, -0.6, 0.6};
  EXPECT_NEAR(footprint_of(drive).first, -1.0, 1e-15);
  EXPECT_NEAR(disc_radius(drive, 0.1), 1.5, 1e-15);
  RobotSetup setup;
  setup.model = drive;
  const std::vector<Disc> discs = discs_at(setup, {2.0, 3.0}, 0.5);
  ASSERT_EQ(discs.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    const Vec2 expected = Vec2{2.0, 3.0} + (-0.6 + 0.6 * k) * Vec2{std::cos(0.5), std::sin(0.5)};
    EXPECT_NEAR(norm(discs[static_cast<std::size_t>(k)].center - expected), 0.0, 1e-12);
  }
}

// What others know of a drive's heading while it brakes, by integration.
TEST(Footprint, a_drive_that_brakes_turns_within_its_pose) {
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const DifferentialDrive drive{.offset = random.log_uniform(0.1, 1.0)};
    const double heading = random.uniform(-3.0, 3.0), u = random.uniform(0.02, 0.2);
    Vec2 velocity = in_disc(random, 2.0);
    const double way = 0.6 * norm(velocity) * norm(velocity) / u;  // more than it takes
    const BrakingPose pose = turn_while_braking(drive, velocity, heading, way);
    double turned = heading, length = 0.0;
    const double direction = std::atan2(velocity.y, velocity.x), step = 1e-3;
    for (int k = 0; k < 4000 && length < way; ++k, length += step) {
      turned += step * std::sin(direction - turned) / drive.offset;
      const double off =
          std::acos(std::min(1.0, dot(pose.ahead, {std::cos(turned), std::sin(turned)})));
      ASSERT_LE(off, pose.spread + 2e-3 / drive.offset);
    }
  }
}

}  // namespace
}  // namespace avo::test
