// SPDX-License-Identifier: Apache-2.0
// Points, balls and planes of R^K, for programs of any dimension.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "space/program.h"

namespace avo::space::geometry {

// m/s for velocities: a half-space that is violated by less counts as kept.
inline constexpr double kTolerance = 1e-10;
// Sine of the angle of two normals below which they are parallel as far as rounding tells.
inline constexpr double kParallelNormals = 1e-9;

template <std::size_t K>
using Point = std::array<double, K>;
template <std::size_t K>
using Plane = typename ProgramLevel<K>::Plane;

template <std::size_t K>
double dot(const std::array<double, K>& a, const std::array<double, K>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < K; ++i) sum += a[i] * b[i];
  return sum;
}
/// a + s b
template <std::size_t K>
std::array<double, K> moved(std::array<double, K> a, double s, const std::array<double, K>& b) {
  for (std::size_t i = 0; i < K; ++i) a[i] += s * b[i];
  return a;
}
template <std::size_t K>
double norm(const std::array<double, K>& a) {
  return std::sqrt(dot(a, a));
}
inline Point<3> point_of(Vec3 a) {
  return {a.x, a.y, a.z};
}

template <std::size_t K>
struct Sphere {
  Point<K> center;
  double radius;
};

/// What is wanted: the point nearest to `wish`, or the farthest one along `direction`.
template <std::size_t K>
struct Objective {
  bool is_linear = false;
  Point<K> wish{}, direction{};
};

template <std::size_t K>
bool is_in(const Sphere<K>& ball, const Point<K>& a) {
  return norm(moved(a, -1.0, ball.center)) <= ball.radius + kTolerance;
}

// The point of one ball that is best.
template <std::size_t K>
Point<K> best_of(const Sphere<K>& ball, const Objective<K>& objective) {
  if (objective.is_linear) {
    const double length = norm(objective.direction);
    return moved(ball.center, ball.radius / length, objective.direction);
  }
  const Point<K> to_wish = moved(objective.wish, -1.0, ball.center);
  const double length = norm(to_wish);
  return length <= ball.radius ? objective.wish : moved(ball.center, ball.radius / length, to_wish);
}

// The best point of the sphere in which both spheres meet.
template <std::size_t K>
Point<K> best_of_meeting(const std::array<Sphere<K>, 2>& balls, const Objective<K>& objective) {
  Point<K> axis = moved(balls[1].center, -1.0, balls[0].center);
  const double length = norm(axis), r0 = balls[0].radius, r1 = balls[1].radius;
  for (double& x : axis) x /= length;
  const double foot = (length * length + r0 * r0 - r1 * r1) / (2.0 * length);
  const double radius = std::sqrt(std::max((r0 - foot) * (r0 + foot), 0.0));
  const Point<K> center = moved(balls[0].center, foot, axis);
  Point<K> side = objective.is_linear ? objective.direction : moved(objective.wish, -1.0, center);
  side = moved(side, -dot(side, axis), axis);
  const double off = norm(side);
  return off > 0.0 ? moved(center, radius / off, side) : center;
}

// The best point of both balls; false where they do not meet.
template <std::size_t K>
bool best_in_balls(const std::array<Sphere<K>, 2>& balls, Objective<K> objective, Point<K>& best) {
  if (objective.is_linear && !(norm(objective.direction) > kTolerance)) objective.is_linear = false;
  for (std::size_t k = 0; k < 2; ++k) {
    best = best_of(balls[k], objective);
    if (is_in(balls[1 - k], best)) return true;
  }
  const double length = norm(moved(balls[1].center, -1.0, balls[0].center));
  if (!(length <= balls[0].radius + balls[1].radius + kTolerance) || !(length > 0.0)) return false;
  best = best_of_meeting(balls, objective);
  return true;
}

// The axis of the largest coordinate. Of equal x and y it is that which a turn by 90 degrees about
// z takes to the one for the turned normal.
template <std::size_t K>
std::size_t largest_of(const Point<K>& normal) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < K; ++i) {
    const double one = std::abs(normal[i]), before = std::abs(normal[largest]);
    const bool wins_tie = i == 1 && one == before && (normal[0] > 0.0) != (normal[1] > 0.0);
    if (one > before || wins_tie) largest = i;
  }
  return largest;
}

/// A plane of R^K as R^(K-1): its unit normal, its place along the normal, and a basis. The basis
/// is that of a reflection which takes the largest axis to the normal.
template <std::size_t K>
struct Flat {
  Point<K> normal;
  double offset;
  std::array<Point<K>, K - 1> basis;

  explicit Flat(const Plane<K>& plane) : normal(plane.normal), offset(plane.offset) {
    const std::size_t largest = largest_of(normal);
    Point<K> mirror = normal;
    mirror[largest] += normal[largest] >= 0.0 ? 1.0 : -1.0;
    const double per_squared = 1.0 / dot(mirror, mirror);
    for (std::size_t i = 0, k = 0; i < K; ++i) {
      if (i == largest) continue;
      Point<K> axis{};
      axis[i] = 1.0;
      basis[k++] = moved(axis, -2.0 * mirror[i] * per_squared, mirror);
    }
  }
  Point<K - 1> down(const Point<K>& a) const {
    Point<K - 1> result;
    for (std::size_t k = 0; k < K - 1; ++k) result[k] = dot(a, basis[k]);
    return result;
  }
  Point<K> up(const Point<K - 1>& a) const {
    // the basis first: turning the axes about each other changes no bit
    Point<K> result{};
    for (std::size_t k = 0; k < K - 1; ++k) result = moved(result, a[k], basis[k]);
    return moved(result, offset, normal);
  }
};

}  // namespace avo::space::geometry
