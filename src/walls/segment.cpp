// SPDX-License-Identifier: Apache-2.0
#include "walls/segment.h"

namespace avo::inline walls {
namespace {

// Returns whether the ends of each lie on different sides of the other one. Where rounding hides a
// side, an end is as near to the other segment as that rounding.
bool cross_each_other(const Segment& first, const Segment& second) {
  const Vec2 d = first.b - first.a, e = second.b - second.a;
  const double from_a = cross(d, second.a - first.a), from_b = cross(d, second.b - first.a);
  const double to_a = cross(e, first.a - second.a), to_b = cross(e, first.b - second.a);
  return ((from_a < 0.0) != (from_b < 0.0)) && ((to_a < 0.0) != (to_b < 0.0)) && from_a != 0.0 &&
         from_b != 0.0 && to_a != 0.0 && to_b != 0.0;
}

}  // namespace

NearestPoints nearest_points(const Segment& first, const Segment& second) {
  if (cross_each_other(first, second)) {
    const Vec2 d = first.b - first.a, e = second.b - second.a;
    const Vec2 meeting = first.a + (cross(second.a - first.a, e) / cross(d, e)) * d;
    return {meeting, meeting, 0.0};
  }
  // one of the four ends is one of the nearest points
  NearestPoints nearest{first.a, nearest_on(second, first.a)};
  nearest.distance = norm(nearest.on_first - nearest.on_second);
  const auto try_points = [&nearest](Vec2 on_first, Vec2 on_second) {
    const double between = norm(on_first - on_second);
    if (between < nearest.distance) nearest = {on_first, on_second, between};
  };
  try_points(first.b, nearest_on(second, first.b));
  try_points(nearest_on(first, second.a), second.a);
  try_points(nearest_on(first, second.b), second.b);
  return nearest;
}

double distance(const Segment& first, const Segment& second) {
  return nearest_points(first, second).distance;
}

}  // namespace avo::inline walls
