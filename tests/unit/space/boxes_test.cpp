// SPDX-License-Identifier: Apache-2.0
#include "space/boxes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace avo::space::tests
