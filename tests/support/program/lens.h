// SPDX-License-Identifier: Apache-2.0
// The intersection of two closed discs, exact: what the acceleration limit and the speed limit
// leave a robot to choose from (paper §IV-D, the disc of Eq. 21 and a second one).
#pragma once
#include "avo/geometry.h"

namespace avo::reference {

/// Both closed discs, in coordinates relative to the center of the smaller one: there the numbers
/// are as small as the set, so that nothing cancels where the discs lie far from the origin.
struct Lens {
  Vec2 origin;                   ///< center of the smaller disc, already multiplied by scale
  double scale = 1.0;            ///< power of two; 1 unless squares of the input over- or underflow
  double radius = 0.0;           ///< of the smaller disc, whose center is 0 here
  bool empty = false;            ///< the discs do not meet
  bool two_arcs = false;         ///< false: the larger disc holds the smaller one and plays no part
  bool speed_is_larger = false;  ///< which of the two discs is meant by `larger_`
  Vec2 larger_center;            ///< relative, like all vectors below
  double larger_radius = 0.0;
  double distance = 0.0;  ///< between the centers

  /// What rounding may do to a plane's violation, n . u - offset, near the set: 8 ulp of the
  /// largest number that takes part. Planes violated by less count as satisfied.
  double tolerance = 0.0;
  double larger_tolerance = 0.0;  ///< the same for the larger disc's boundary
};

/// Requires finite centers, radii >= 0, speed.radius finite. Discs count as touching where the
/// gap between them is within rounding, 2 ulp of |c| + r of the larger one.
Lens make_lens(const Disc& acceleration, const Disc& speed) noexcept;

struct LensPoint {
  Vec2 point;
  bool moved = false;  ///< it is not the point asked about, which lies outside
};

/// The point of the lens nearest p, in closed form. Lens not empty.
LensPoint nearest(const Lens& lens, Vec2 p) noexcept;

/// The point of the lens with the largest direction . point, in closed form. Lens not empty.
Vec2 farthest_along(const Lens& lens, Vec2 direction) noexcept;

/// The smallest normal . u over both discs, m/s: a half-plane whose offset is not above it holds
/// for everything that the robot may choose. +infinity if the discs do not meet.
double lens_support_min(Vec2 normal, const Lens& lens) noexcept;
double lens_support_min(Vec2 normal, const Disc& acceleration, const Disc& speed) noexcept;

}  // namespace avo::reference
