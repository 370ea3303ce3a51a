// SPDX-License-Identifier: Apache-2.0
// The intersection of two closed discs, exact. It has the velocities that the acceleration limit
// and the speed limit allow a robot (paper §IV-D, the disc of Eq. 21 and a second one).
#pragma once
#include "avo/geometry.h"

namespace avo::reference {

/// Both closed discs, in coordinates relative to the center of the smaller one. There the numbers
/// are as small as the set, so nothing cancels if the discs are far from the origin.
struct Lens {
  Vec2 origin;            ///< center of the smaller disc, already multiplied by scale
  double scale = 1.0;     ///< power of two; 1 unless squares of the input over- or underflow
  double radius = 0.0;    ///< of the smaller disc; the center of this disc is 0 here
  bool empty = false;     ///< the discs do not meet
  bool two_arcs = false;  ///< false: the larger disc contains the smaller one and has no effect
  bool speed_is_larger = false;  ///< the disc that `larger_` means
  Vec2 larger_center;            ///< relative, like all vectors below
  double larger_radius = 0.0;
  double distance = 0.0;  ///< between the centers

  /// The largest effect of rounding on a plane's violation, n . u - offset, near the set: 8 ulp of
  /// the largest number involved. Planes with a smaller violation count as satisfied.
  double tolerance = 0.0;
  double larger_tolerance = 0.0;  ///< the same for the larger disc's boundary
};

/// Requires finite centers, radii >= 0, speed.radius finite. Discs count as touching if the gap
/// between them is within rounding, 2 ulp of |c| + r of the larger one.
Lens make_lens(const Disc& acceleration, const Disc& speed) noexcept;

struct LensPoint {
  Vec2 point;
  bool moved = false;  ///< it differs from the given point, which lies outside
};

/// Returns the point of the lens nearest p, in closed form. The lens must not be empty.
LensPoint nearest(const Lens& lens, Vec2 p) noexcept;

/// Returns the point of the lens with the largest direction . point, in closed form. The lens must
/// not be empty.
Vec2 farthest_along(const Lens& lens, Vec2 direction) noexcept;

/// Returns the smallest normal . u over both discs, m/s. A half-plane with an offset that is not
/// above this value holds for all velocities that the robot may choose. The value is +infinity if
/// the discs do not meet.
double lens_support_min(Vec2 normal, const Lens& lens) noexcept;
double lens_support_min(Vec2 normal, const Disc& acceleration, const Disc& speed) noexcept;

}  // namespace avo::reference
