// SPDX-License-Identifier: Apache-2.0
// The intersection of two closed discs in closed form: the velocities that the limits on
// acceleration and speed allow a robot (paper §IV-D, Eqs. (21), (22)), one robot per lane. In
// coordinates relative to the center of the smaller disc, numbers are as small as the set. So
// nothing cancels where the discs are far from the origin. No invalid operation occurs, not even in
// an unused lane.
#ifndef AVO_LP_LENS_KERNEL_H
#define AVO_LP_LENS_KERNEL_H

#include "core/scalar.h"
#include "lp/constants.h"

AVO_BEGIN_KERNELS
namespace planar {

template <typename Real>
using Mask = decltype(Real() < Real());

template <typename Real>
AVO_KERNEL Real clamp(Real a, Real lo, Real hi) {
  return select(a < lo, lo, select(hi < a, hi, a));
}

/// The acceleration disc; the speed disc lies around 0.
template <typename Real>
struct LimitDiscs {
  Vec<Real> center;
  Real radius, top_speed;
};

/// Discs count as touching where the gap between them is within rounding, 2 ulp of |c| + r of the
/// larger one.
template <typename Real>
struct LensOf {
  Vec<Real> origin;  // center of the smaller disc
  Real radius;       // of the smaller disc
  // The effect of rounding on a plane's violation near the set: 8 ulp of the largest number
  // involved. Planes violated by less count as satisfied; the same holds for the larger disc's
  // edge.
  Real tolerance, larger_tolerance;
  Vec<Real> larger_center;
  Real larger_radius, distance;  // between the centers
  Mask<Real> speed_is_larger;
  Mask<Real> two_arcs;  // if false, the larger disc contains the smaller one and has no effect
  Mask<Real> ordinary;  // the discs meet, and squares of their numbers neither over- nor underflow
};

template <typename Real>
AVO_KERNEL Real largest_component(Vec<Real> a) {
  return max(abs(a.x), abs(a.y));
}

template <typename Real>
AVO_KERNEL Mask<Real> is_within(Vec<Real> a, double largest) {
  return (abs(a.x) <= Real(largest)) & (abs(a.y) <= Real(largest));
}

/// An infinite radius is no limit, and does not count as a size.
template <typename Real>
AVO_KERNEL Mask<Real> is_ordinary(const LimitDiscs<Real>& discs) {
  const Real zero = 0.0;
  const Mask<Real> unlimited = discs.radius >= Real(std::numeric_limits<double>::infinity());
  const Real radius = select(unlimited, zero, discs.radius);
  const Real size = max(largest_component(discs.center), max(radius, discs.top_speed));
  return is_within(discs.center, kLargestSize) &
         is_within(Vec<Real>{radius, discs.top_speed}, kLargestSize) &
         ((size >= Real(kSmallestSize)) | (size <= zero));
}

template <typename Real>
AVO_KERNEL LensOf<Real> make_lens(const LimitDiscs<Real>& discs) {
  const Vec<Real> zero{0.0, 0.0};
  const Real ulps = kToleranceUlps * kUlp;
  LensOf<Real> lens;
  lens.speed_is_larger = discs.radius <= discs.top_speed;
  const Vec<Real> larger_center = select(lens.speed_is_larger, zero, discs.center);
  lens.origin = select(lens.speed_is_larger, discs.center, zero);
  lens.radius = select(lens.speed_is_larger, discs.radius, discs.top_speed);
  lens.tolerance = ulps * (largest_component(lens.origin) + lens.radius);
  lens.larger_radius = select(lens.speed_is_larger, discs.top_speed, discs.radius);
  lens.larger_center = larger_center - lens.origin;
  lens.distance = norm(lens.larger_center);
  lens.two_arcs = lens.distance > lens.larger_radius - lens.radius;
  lens.larger_tolerance = ulps * (largest_component(larger_center) + lens.larger_radius);
  const Real gap = (lens.distance - lens.larger_radius) - lens.radius;
  const Mask<Real> empty = gap > Real(kTouchingUlps / kToleranceUlps) * lens.larger_tolerance;
  lens.ordinary = is_ordinary(discs) & !(lens.two_arcs & empty);
  return lens;
}

template <typename Real>
AVO_KERNEL Mask<Real> in_smaller(const LensOf<Real>& lens, Vec<Real> u, double rounding) {
  return dot(u, u) <= lens.radius * lens.radius * Real(rounding);
}

template <typename Real>
AVO_KERNEL Mask<Real> in_larger(const LensOf<Real>& lens, Vec<Real> u, double rounding) {
  const Vec<Real> q = u - lens.larger_center;
  return (!lens.two_arcs) | (dot(q, q) <= lens.larger_radius * lens.larger_radius * Real(rounding));
}

template <typename Real>
AVO_KERNEL Vec<Real> corner_towards(const LensOf<Real>& lens, Vec<Real> p) {
  const Real r = lens.radius, R = lens.larger_radius, D = lens.distance;
  const Real raw = ((r - R) * (r + R) + D * D) / (Real(2.0) * D);
  const Real along = clamp(raw, -r, r);
  const Real height = sqrt((r - along) * (r + along));
  const Real side = select(cross(lens.larger_center, p) >= Real(0.0), Real(1.0), Real(-1.0));
  const Vec<Real> axis = lens.larger_center / D;
  return along * axis + (side * height) * perpendicular(axis);
}

template <typename Real>
struct LensPoint {
  Vec<Real> point;
  Mask<Real> moved;
};

template <typename Real>
AVO_KERNEL LensPoint<Real> nearest(const LensOf<Real>& lens, Vec<Real> p) {
  constexpr double rounding = kRoundingOfSquares;
  const Mask<Real> inside_smaller = in_smaller(lens, p, 1.0);
  const Mask<Real> inside_larger = in_larger(lens, p, 1.0);
  const Mask<Real> moved = !(inside_smaller & inside_larger);
  if (!any(moved & lens.ordinary)) return {p, moved};
  Mask<Real> open = moved;
  Vec<Real> point = p;
  if (any(!inside_smaller)) {
    const Vec<Real> on_smaller = (lens.radius / norm(p)) * p;
    const Mask<Real> here = open & !inside_smaller & in_larger(lens, on_smaller, rounding);
    point = select(here, on_smaller, point);
    open = open & !here;
    if (!any(open & lens.ordinary)) return {point, moved};
  }
  if (any(!inside_larger)) {
    const Vec<Real> q = p - lens.larger_center;
    const Vec<Real> on_larger = lens.larger_center + (lens.larger_radius / norm(q)) * q;
    const Mask<Real> here = open & !inside_larger & in_smaller(lens, on_larger, rounding);
    point = select(here, on_larger, point);
    open = open & !here;
    if (!any(open & lens.ordinary)) return {point, moved};
  }
  return {select(open, corner_towards(lens, p), point), moved};
}

template <typename Real>
AVO_KERNEL Vec<Real> farthest_along(const LensOf<Real>& lens, Vec<Real> direction) {
  constexpr double rounding = kRoundingOfSquares;
  const Vec<Real> n = direction / norm(direction);
  const Vec<Real> on_smaller = lens.radius * n;
  const Mask<Real> smaller = in_larger(lens, on_smaller, rounding);
  if (!any(!smaller)) return on_smaller;
  const Vec<Real> on_larger = lens.larger_center + lens.larger_radius * n;
  const Mask<Real> larger = in_smaller(lens, on_larger, rounding);
  return select(smaller, on_smaller, select(larger, on_larger, corner_towards(lens, n)));
}

/// Moves the point back into the discs, the smaller one last.
template <typename Real>
AVO_KERNEL Vec<Real> absolute_point(const LensOf<Real>& lens, const LimitDiscs<Real>& discs,
                                    Vec<Real> relative) {
  const Vec<Real> larger_center = select(lens.speed_is_larger, Vec<Real>{0.0, 0.0}, discs.center);
  Vec<Real> u = lens.origin + relative;
  const auto put_into = [&u](Vec<Real> center, Real radius) {
    const Vec<Real> q = u - center;
    const Mask<Real> outside = dot(q, q) > radius * radius;
    if (any(outside)) u = select(outside, center + (radius / norm(q)) * q, u);
  };
  put_into(larger_center, lens.larger_radius);
  put_into(lens.origin, lens.radius);
  return u;
}

}  // namespace planar
AVO_END_KERNELS

#endif  // once per pass
