// SPDX-License-Identifier: Apache-2.0
#include "space/boxes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <span>
#include <utility>

#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

// m: from a point to a box, by the definition.
double distance_of(Vec3 a, const Box& box) {
  const double c = std::cos(box.heading), s = std::sin(box.heading);
  const Vec3 in{c * a.x + s * a.y, c * a.y - s * a.x, a.z};
  return norm(in - Vec3{std::clamp(in.x, box.min.x, box.max.x),
                        std::clamp(in.y, box.min.y, box.max.y),
                        std::clamp(in.z, box.min.z, box.max.z)});
}

TEST(Boxes, the_nearest_point_of_a_segment_is_the_nearest) {
  Draws draws(4);
  for (int k = 0; k < 5000; ++k) {
    const Vec3 center = draws.within(3.0);
    const Vec3 half{draws.between(0, 2), draws.between(0, 2), k % 5 == 0 ? 0.0 : 1.0};
    Box box{center - half, center + half, draws.between(-3, 3), 0.0};
    if (k % 3 == 0) box.max.z = Box::kFar;
    if (k % 7 == 0) box.min.x = -Box::kFar;
    const Vec3 a = draws.within(6.0), b = k % 11 == 0 ? a : draws.within(6.0);
    const NearestToBox found = nearest(a, b, box);
    ASSERT_NEAR(norm(found.on_segment - found.on_box), found.distance, 1e-12);
    ASSERT_NEAR(distance_of(found.on_segment, box), found.distance, 1e-12);
    for (int i = 0; i <= 100; ++i)
      ASSERT_LE(found.distance, distance_of(a + (0.01 * i) * (b - a), box) + 1e-12) << k;
  }
}

// A thin pillar below the middle of the triangle of a step: far from its sides, and nearer to its
// inside than the radius.
TEST(Boxes, near_the_inside_of_the_triangle_of_a_step_are_seen) {
  const StepLaw law{.time_step = 1.0, .lag = 0.5, .braking_time = 1.0};
  Robot robot;
  robot.radius = 0.2, robot.max_acceleration = 100.0, robot.max_speed = 100.0;
  robot.velocity = {4, 0, 0};
  const Vec3 next{0, 4, 0}, middle{2, 0, 0}, first{2, 2, 0};
  const Vec3 inside = (middle + first) / 3.0;
  for (const double height : {0.1, 0.19, 2.0}) {
    const Vec3 tip = inside - Vec3{0, 0, height};
    const Box pillar{{tip.x, tip.y, -Box::kFar}, tip, 0.0, 0.0};
    for (const auto& [a, b] : {std::pair(Vec3{}, middle), {middle, first}, {Vec3{}, first}})
      ASSERT_GT(nearest(a, b, pillar).distance, 0.25);
    BoxConstraints constraints;
    begin_boxes(robot, std::span(&pillar, 1), law, constraints);
    ASSERT_FALSE(constraints.broken.any());
    EXPECT_EQ(keeps_boxes(robot, next, law, constraints), height > 0.2) << height;
  }
}

}  // namespace
}  // namespace avo::space::tests
