// SPDX-License-Identifier: Apache-2.0
// Distances of points and segments.
#pragma once
#include "avo/vec.h"

namespace avo::inline walls {

/// From a to b; a point where they are equal.
struct Segment {
  Vec2 a, b;  // m
};

/// A pair of points, one of each set, that are as near to each other as any.
struct NearestPoints {
  Vec2 on_first, on_second;  // m
  double distance = 0.0;     // m; 0 where the sets meet
};

/// The point of the segment nearest to p. Ends are exact.
inline Vec2 nearest_on(const Segment& segment, Vec2 p) {
  const Vec2 d = segment.b - segment.a;
  const double along = dot(p - segment.a, d), length_squared = dot(d, d);
  if (!(along > 0.0)) return segment.a;
  if (!(along < length_squared)) return segment.b;
  return segment.a + (along / length_squared) * d;
}

/// For segments that cross, both are the crossing point, up to rounding.
NearestPoints nearest_points(const Segment& first, const Segment& second);

/// m
inline double distance(Vec2 p, const Segment& segment) {
  return norm(p - nearest_on(segment, p));
}
double distance(const Segment& first, const Segment& second);

/// Returns whether the segment from p to q crosses the line between its ends, from one side to the
/// other. A place on the line is on the same side of it for every segment.
inline bool leads_across(const Segment& line, Vec2 p, Vec2 q) {
  const Vec2 across = line.b - line.a, move = q - p;
  if ((cross(across, p - line.a) < 0.0) == (cross(across, q - line.a) < 0.0)) return false;
  return (cross(move, line.a - p) < 0.0) != (cross(move, line.b - p) < 0.0);
}

}  // namespace avo::inline walls
