// SPDX-License-Identifier: Apache-2.0
// The plane of a pair: both robots choose it alike.
#include "space/frame.h"

#include <gtest/gtest.h>

#include "avo/half_plane.h"
#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

struct Half {
  Vec3 normal;
  double offset;
};

Half half_space(Vec3 p, Vec3 v, const Horizon& horizon) {
  const PairFrame frame = frame_of(p, v);
  const RelativeHalfPlane plane =
      half_plane({{frame.distance, 0.0}, frame.velocity, 1.0}, 2.0, horizon);
  return {turned_back(frame, plane.plane.normal), plane.plane.offset};
}

// Every third pair is a tie: on a head-on course, vertically, or at rest.
void draw(Draws& draws, int k, Vec3& p, Vec3& v) {
  p = draws.between(1.01, 8.0) * draws.direction();
  if (k % 12 == 0) p = {0.0, 0.0, k % 24 == 0 ? 3.0 : -3.0};
  v = k % 3 == 0 ? (k % 2 == 0 ? -0.5 : 0.25) * p : draws.within(3.0);
  if (k % 21 == 0) v = {};
}

TEST(PairFrame, exchanging_the_robots_negates_the_normal_bit_for_bit) {
  Draws draws(2);
  const Horizon horizon(2.0, 3.0, 0.1);
  for (int k = 0; k < 1'000'000; ++k) {
    Vec3 p, v;
    draw(draws, k, p, v);
    const Half a = half_space(p, v, horizon), b = half_space(-p, -v, horizon);
    ASSERT_EQ(a.normal, -b.normal) << k;
    ASSERT_EQ(a.offset, b.offset) << k;
  }
}

TEST(PairFrame, turning_by_90_degrees_about_the_vertical_turns_the_normal_bit_for_bit) {
  Draws draws(3);
  const Horizon horizon(2.0, 3.0, 0.1);
  const auto turned = [](Vec3 a) { return Vec3{-a.y, a.x, a.z}; };
  for (int k = 1; k < 100'000; ++k) {
    if (k % 12 == 0) continue;  // a vertical p has a side of its own
    Vec3 p, v;
    draw(draws, k, p, v);
    const Half a = half_space(p, v, horizon), b = half_space(turned(p), turned(v), horizon);
    ASSERT_EQ(turned(a.normal), b.normal) << k;
    ASSERT_EQ(a.offset, b.offset) << k;
  }
}

TEST(PairFrame, robots_on_a_head_on_course_pass_on_their_right) {
  const PairFrame frame = frame_of({-5, 0, 0}, {1, 0, 0});
  EXPECT_EQ(frame.across, (Vec3{0, -1, 0}));  // left of p, so A goes to its right
  EXPECT_EQ(frame.velocity, (Vec2{-1, 0}));
}

}  // namespace
}  // namespace avo::space::tests
