// SPDX-License-Identifier: Apache-2.0
// Points on a circle with the same bits on every machine.
#pragma once
#include <cstdint>

#include "avo/vec.h"

namespace avo_io {

/// Returns point k of n on the unit circle, from angle 0 counter-clockwise. It is bit for bit the
/// same on every machine, and symmetric: for even n, point k + n/2 is the negative of point k.
inline avo::Vec2 circle_point(int k, int n) {
  constexpr double kEighth = 3.141592653589793 / 4.0;  // rad
  // The angle in eighths of the circle is exact: it is (octant + rest / n) * 45 degrees. It differs
  // by x <= 45 degrees from the nearest axis, `quarters` * 90 degrees.
  const std::int64_t eighths = 8 * static_cast<std::int64_t>(k % n);
  const std::int64_t octant = eighths / n, rest = eighths % n;
  const bool back = octant % 2 == 1;
  const double x = kEighth * static_cast<double>(back ? n - rest : rest) / n;
  double sine = 1.0, cosine = 1.0;
  for (double i = 20.0; i >= 2.0; i -= 2.0) {  // Taylor series; the truncation error is below 1e-22
    sine = 1.0 - x * x / (i * (i + 1.0)) * sine;
    cosine = 1.0 - x * x / (i * (i - 1.0)) * cosine;
  }
  avo::Vec2 point{cosine, back ? -x * sine : x * sine};
  const std::int64_t quarters = (octant + 1) / 2;
  for (std::int64_t i = 0; i < quarters; ++i) point = perpendicular(point);
  return point + avo::Vec2{};  // no -0
}

}  // namespace avo_io
