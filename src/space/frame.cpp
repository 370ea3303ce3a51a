// SPDX-License-Identifier: Apache-2.0
#include "space/frame.h"

#include <cmath>

namespace avo::space {
namespace {

// |v_2| below this part of |v|: p and v are parallel as far as rounding tells.
constexpr double kParallelCourse = 1e-9;
// (horizontal/vertical)² of p below this: p is vertical as far as rounding tells.
constexpr double kVerticalPlace = 1e-12;

// A unit vector across p, odd in p.
Vec3 side_of(Vec3 p) {
  const double horizontal = p.x * p.x + p.y * p.y;
  if (horizontal > kVerticalPlace * (p.z * p.z)) {
    const double length = std::sqrt(horizontal);
    return {-p.y / length, p.x / length, 0.0};
  }
  const double length = std::sqrt(p.y * p.y + p.z * p.z);
  return {0.0, -p.z / length, p.y / length};
}

}  // namespace

PairFrame frame_of(Vec3 p, Vec3 v) {
  PairFrame frame;
  frame.distance = norm(p);
  frame.along = p / frame.distance;
  const double along = dot(frame.along, v);
  const Vec3 rest = v - along * frame.along;
  const double across = norm(rest);
  if (!(across > kParallelCourse * norm(v))) {
    frame.across = side_of(p);
    frame.velocity = {along, 0.0};
    return frame;
  }
  const Vec3 first = rest / across;
  const Vec3 second = first - dot(first, frame.along) * frame.along;  // rounding was left
  frame.across = second / norm(second);
  frame.velocity = {along, across};
  return frame;
}

}  // namespace avo::space
