// SPDX-License-Identifier: Apache-2.0
// The common direction of a pair of space: it proves the whole distance, and both robots choose it.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "certificate/shape_kernel.h"
#include "space/certificate.h"
#include "space/own_space.h"
#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

using Real = scalar::Pack<double>;
using Points = scalar::PackPoints<Real, 3>;

struct Triangle {
  Vec3 start, middle, end;

  Points pack() const {
    return {scalar::constant<Real>(start), scalar::constant<Real>(middle),
            scalar::constant<Real>(end)};
  }
};

double distance_to(Vec3 q, const PairShape<3>& shape) {
  q.z -= std::clamp(q.z, -shape.down, shape.up);
  return norm(q);
}

// The least value of a convex function on [0, most].
template <typename F>
double least(const F& value, double most) {
  double low = 0.0, high = most;
  for (int i = 0; i < 60; ++i) {
    const double x = low + (high - low) / 3.0, y = high - (high - low) / 3.0;
    (value(x) < value(y) ? high : low) = value(x) < value(y) ? y : x;
  }
  return value(0.5 * (low + high));
}

// m: the distance of the triangle from the segment of the shape, which is convex over the triangle.
double distance_of_triangle(const Triangle& t, const PairShape<3>& shape) {
  return least(
      [&](double x) {
        return least(
            [&](double y) {
              return distance_to(t.start + x * (t.middle - t.start) + y * (t.end - t.start), shape);
            },
            1.0 - x);
      },
      1.0);
}

// m: what the direction proves.
double proved(const Triangle& t, const PairShape<3>& shape, Vec3 n) {
  return std::min({dot(n, t.start), dot(n, t.middle), dot(n, t.end)}) -
         std::max(n.z * shape.up, -n.z * shape.down);
}

Triangle draw(Draws& draws) {
  // thin and wide ones; the origin is often beside the face
  const Vec3 center = draws.between(0.2, 3.0) * draws.direction();
  const double size = draws.between(0.1, 4.0);
  return {center + size * draws.direction(), center + size * draws.direction(),
          center + size * draws.direction()};
}

PairShape<3> shape_of(Draws& draws, int k) {
  PairShape<3> shape;
  if (k % 2 == 0) shape.up = draws.between(0.0, 1.5);
  if (k % 3 == 0) shape.down = draws.between(0.0, 1.5);
  return shape;
}

TEST(SpaceNormals, prove_the_distance_of_the_triangle) {
  Draws draws(11);
  int faces = 0;
  for (int k = 0; k < 500; ++k) {
    const Triangle t = draw(draws);
    const PairShape<3> shape = shape_of(draws, k);
    const double distance = distance_of_triangle(t, shape);
    if (!(distance > 1e-3)) continue;
    const Vec3 n = scalar::plain(scalar::normal_of(t.pack(), shape));
    ASSERT_NEAR(norm(n), 1.0, 1e-12);
    ASSERT_NEAR(proved(t, shape, n), distance, 1e-4 * (1.0 + distance)) << k;
    const Vec3 face = cross(t.middle - t.start, t.end - t.start);
    if (norm(cross(face, n)) < 1e-9 * norm(face)) ++faces;
  }
  EXPECT_GT(faces, 20);  // the nearest point is inside of the face
}

// A pair that brakes on one interval above the middle of the triangle of its relative path.
TEST(SpaceNormals, leave_the_whole_distance_above_the_face_of_a_braking_pair) {
  Draws draws(13);
  const StepLaw law{.time_step = 1.0, .lag = 0.5, .braking_time = 1.0};
  Constraints constraints;
  int judged = 0;
  for (int k = 0; k < 300; ++k) {
    Robot a;
    a.radius = 0.2, a.max_acceleration = 1.0;
    a.velocity = draws.between(1.05, 1.95) * draws.direction();
    Robot b = a;
    b.velocity = draws.between(1.05, 1.95) * draws.direction();
    // both brake for two steps: from v to v - u, and to rest
    const auto first = [](Vec3 v) { return 0.5 * v; };
    const auto end = [](Vec3 v) { return 0.5 * v + 0.5 * (1.0 - 1.0 / norm(v)) * v; };
    const Triangle relative{
        {}, first(a.velocity) - first(b.velocity), end(a.velocity) - end(b.velocity)};
    const Vec3 face = cross(relative.middle, relative.end);
    if (!(norm(face) > 0.05)) continue;
    const Vec3 center = (relative.middle + relative.end) / 3.0;
    const double height = 0.45;
    a.position = (height / norm(face)) * face - center;
    Bodies bodies;
    bodies.reserve(1);
    bodies.add(neighbor_of(b), 0);
    fill_braking(law, bodies);
    const NearBody near{0, 0.0};
    begin_constraints(a, braking_of(a, law), law, constraints);
    collect_constraints(a, bodies, std::span(&near, 1), {}, law, constraints);
    append_needed(a, {1e6, 0, 0}, law, constraints);
    ASSERT_TRUE(constraints.waiting.empty());
    const Triangle moved{a.position, a.position + relative.middle, a.position + relative.end};
    ASSERT_NEAR(distance_of_triangle(moved, {}), height, 1e-6);
    // later intervals may be nearer; none is farther
    if (constraints.invariant.slack > height - 0.4 - 1e-9) ++judged;
  }
  EXPECT_GT(judged, 20);
}

TEST(SpaceNormals, are_opposite_for_the_other_robot_bit_for_bit) {
  Draws draws(12);
  for (int k = 0; k < 20'000; ++k) {
    Triangle t = draw(draws);
    if (k % 5 == 0) t.start.z = t.middle.z = t.end.z = k % 10 == 0 ? 0.0 : 0.7;
    if (k % 7 == 0) t.middle = t.end = t.start;
    const PairShape<3> shape = shape_of(draws, k);
    PairShape<3> other = shape;
    if (k % 11 == 0) other.up = other.down = shape.up;
    PairShape<3> same = other;
    std::swap(other.up, other.down);
    const Triangle negated{-t.start, -t.middle, -t.end};
    const Vec3 a = scalar::plain(scalar::normal_of(t.pack(), same));
    const Vec3 b = scalar::plain(scalar::normal_of(negated.pack(), other));
    ASSERT_EQ(a, -b) << k;
  }
}

}  // namespace
}  // namespace avo::space::tests
