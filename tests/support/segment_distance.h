// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>

#include "avo/vec.h"

namespace avo::test {

/// Returns m, from a point to the segment from a to b; it shares no code with the library.
inline double slow_segment_distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double squared = norm_squared(d);
  const double part = squared > 0.0 ? std::clamp(dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
  return norm(p - (a + part * d));
}

}  // namespace avo::test
