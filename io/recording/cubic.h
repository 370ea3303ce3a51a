// SPDX-License-Identifier: Apache-2.0
// Places between two rows of a recording.
#pragma once

namespace avo_io {

/// Returns a point on the cubic through a with velocity v and through b with velocity w, which are
/// `step` seconds apart. `part`: of the step, from a. In the plane and in space.
template <class Vec>
Vec on_cubic(Vec a, Vec v, Vec b, Vec w, double part, double step) {
  const double s = part, s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * a + (3 * s2 - 2 * s3) * b + ((s3 - 2 * s2 + s) * step) * v +
         ((s3 - s2) * step) * w;
}

}  // namespace avo_io
