// SPDX-License-Identifier: Apache-2.0
// The intersection of the acceleration disc and the speed disc for one robot: the scalar instance
// of lens_kernel.h, for numbers of any size.
#pragma once
#include "avo/geometry.h"
#include "lp/lens_kernel.h"

namespace avo::inline lp {

struct Lens {
  using Real = scalar::Pack<double>;
  scalar::planar::LensOf<Real> scaled;  ///< in this, all lengths are multiplied by `scale`
  double scale = 1.0;                   ///< power of two; 1 unless squares would over- or underflow
  Disc smaller;                         ///< of the two discs, as given
  double gap = 0.0;                     ///< m/s, between the discs, > 0 if they do not meet
  bool empty = false;                   ///< they do not meet
};

/// The scale of these discs.
double safe_scale(const Disc& acceleration, double top_speed) noexcept;

/// Requires a finite center and top_speed, radius >= 0, top_speed >= 0.
Lens make_lens(const Disc& acceleration, double top_speed) noexcept;

/// The point of the lens nearest u. Lens not empty.
Vec2 nearest(const Lens& lens, Vec2 u) noexcept;

/// The smallest normal . u over both discs, m/s. A half-plane with at most this offset holds for
/// every velocity that the robot may choose. +infinity if the discs do not meet.
double lens_support_min(Vec2 normal, const Lens& lens) noexcept;

}  // namespace avo::inline lp
