// SPDX-License-Identifier: Apache-2.0
// How far a box is from places and straight paths.
#include <algorithm>
#include <array>

#include "core/elementary.h"
#include "space/boxes.h"

namespace avo::space {
namespace {

// The frame of a box: its axes x and y, turned about the vertical.
struct BoxFrame {
  double c = 1.0, s = 0.0;

  explicit BoxFrame(const Box& box) {
    if (box.heading == 0.0) return;
    const Vec2 axis = elementary::direction(box.heading);
    c = axis.x, s = axis.y;
  }
  Vec3 in(Vec3 a) const { return {c * a.x + s * a.y, c * a.y - s * a.x, a.z}; }
  Vec3 out(Vec3 a) const { return {c * a.x - s * a.y, s * a.x + c * a.y, a.z}; }
};

std::array<double, 3> numbers(Vec3 a) {
  return {a.x, a.y, a.z};
}

// Half of the derivative of the squared distance of a + t d from the box.
double slope(const std::array<double, 3>& a, const std::array<double, 3>& d,
             const std::array<double, 3>& min, const std::array<double, 3>& max, double t) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = a[i] + t * d[i];
    sum += d[i] * (x - std::clamp(x, min[i], max[i]));
  }
  return sum;
}

// The squared distance is convex in t, and a parabola between its kinks at the bounds of the box.
// At each kink the slope tells on which side the minimum is; one parabola is left at last.
double nearest_part(const std::array<double, 3>& a, const std::array<double, 3>& d,
                    const Box& box) {
  const std::array<double, 3> min = numbers(box.min), max = numbers(box.max);
  double low = 0.0, high = 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (d[i] == 0.0) continue;
    for (const double bound : {min[i], max[i]}) {
      const double t = (bound - a[i]) / d[i];  // infinite where the bound is
      if (!(t > low && t < high)) continue;
      (slope(a, d, min, max, t) < 0.0 ? low : high) = t;
    }
  }
  const double at_low = slope(a, d, min, max, low), at_high = slope(a, d, min, max, high);
  if (at_low >= 0.0) return low;
  if (at_high <= 0.0) return high;
  return low + (high - low) * (at_low / (at_low - at_high));
}

}  // namespace

Box moved(const Box& box, Vec3 by) {
  const Vec3 in_box = BoxFrame(box).in(by);
  Box there = box;
  there.min = there.min + in_box, there.max = there.max + in_box;
  return there;
}

NearestToBox nearest(Vec3 a, Vec3 b, const Box& box) {
  const BoxFrame frame(box);
  const Vec3 from = frame.in(a), along = frame.in(b)-from;
  NearestToBox result;
  result.part = nearest_part(numbers(from), numbers(along), box);
  const Vec3 on_segment = from + result.part * along;
  const Vec3 on_box{std::clamp(on_segment.x, box.min.x, box.max.x),
                    std::clamp(on_segment.y, box.min.y, box.max.y),
                    std::clamp(on_segment.z, box.min.z, box.max.z)};
  result.distance = norm(on_segment - on_box);
  result.on_segment = frame.out(on_segment);
  result.on_box = frame.out(on_box);
  return result;
}

Vec3 displacement_to(const Box& box, Vec3 place) {
  const NearestToBox found = nearest(place, place, box);
  if (found.distance <= box.radius) return {};
  return (1.0 - box.radius / found.distance) * (found.on_box - place);
}

}  // namespace avo::space
