// SPDX-License-Identifier: Apache-2.0
// One robot's lens, from the kernel.
#include "lp/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace avo::inline lp {
namespace {

using Real = Lens::Real;
using LensVec = scalar::Vec<Real>;

Vec2 absolute(const Lens& lens, LensVec relative) {
  return plain(lens.scaled.origin + relative) / lens.scale;
}

}  // namespace

double safe_scale(const Disc& acceleration, double top_speed) noexcept {
  double size =
      std::max({std::abs(acceleration.center.x), std::abs(acceleration.center.y), top_speed});
  if (std::isfinite(acceleration.radius)) size = std::max(size, acceleration.radius);
  if (size <= kLargestSize && (size >= kSmallestSize || size == 0.0)) return 1.0;
  return std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
}

Lens make_lens(const Disc& acceleration, double top_speed) noexcept {
  const double scale = safe_scale(acceleration, top_speed);
  const Vec2 center = scale * acceleration.center;
  const auto scaled = scalar::planar::make_lens<Real>(
      {scalar::constant<Real>(center), scale * acceleration.radius, scale * top_speed});
  const Disc speed{{}, top_speed};
  const Disc& smaller = acceleration.radius <= top_speed ? acceleration : speed;
  const double gap = (scaled.distance - scaled.larger_radius - scaled.radius).value / scale;
  return {scaled, scale, smaller, gap, !scaled.ordinary.bit};
}

Vec2 nearest(const Lens& lens, Vec2 u) noexcept {
  const LensVec relative = scalar::constant<Real>(lens.scale * u) - lens.scaled.origin;
  return absolute(lens, scalar::planar::nearest(lens.scaled, relative).point);
}

double lens_support_min(Vec2 normal, const Lens& lens) noexcept {
  if (lens.empty) return std::numeric_limits<double>::infinity();
  const LensVec lowest =
      scalar::planar::farthest_along(lens.scaled, scalar::constant<Real>(-normal));
  return dot(scalar::constant<Real>(normal), lens.scaled.origin + lowest).value / lens.scale;
}

}  // namespace avo::inline lp
