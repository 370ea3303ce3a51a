// SPDX-License-Identifier: Apache-2.0
// The lens of lp/lens.h, one robot per lane, by the same operations in the same order. Included
// into a namespace that has Pack, once per instruction set.

template <typename Real>
using Mask = decltype(Real() < Real());

template <typename Real>
AVO_KERNEL Real clamp(Real a, Real lo, Real hi) {
  return select(a < lo, lo, select(hi < a, hi, a));
}

/// The acceleration disc; the speed disc lies around 0.
template <typename Real>
struct Discs {
  Vec<Real> center;
  Real radius, top_speed;
};

template <typename Real>
struct Lens {
  Vec<Real> origin;
  Real radius, tolerance;
  Vec<Real> larger_center;
  Real larger_radius, larger_tolerance, distance;
  Mask<Real> speed_is_larger, two_arcs;
  Mask<Real> ordinary;  // scale 1, not empty
};

template <typename Real>
AVO_KERNEL Real largest_component(Vec<Real> a) {
  return max(abs(a.x), abs(a.y));
}

template <typename Real>
AVO_KERNEL Mask<Real> is_ordinary(Vec<Real> a) {
  const Real largest = kLargest;
  return (abs(a.x) <= largest) & (abs(a.y) <= largest);
}

template <typename Real>
AVO_KERNEL Mask<Real> is_ordinary(const Discs<Real>& discs) {
  const Real size = max(largest_component(discs.center), max(discs.radius, discs.top_speed));
  return is_ordinary(discs.center) & is_ordinary(Vec<Real>{discs.radius, discs.top_speed}) &
         (size >= Real(kSmallest));
}

template <typename Real>
AVO_KERNEL Lens<Real> make_lens(const Discs<Real>& discs) {
  const Vec<Real> zero{0.0, 0.0};
  const Real ulps = kToleranceUlps * kUlp;
  Lens<Real> lens;
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
AVO_KERNEL Mask<Real> in_smaller(const Lens<Real>& lens, Vec<Real> u, double rounding) {
  return dot(u, u) <= lens.radius * lens.radius * Real(rounding);
}

template <typename Real>
AVO_KERNEL Mask<Real> in_larger(const Lens<Real>& lens, Vec<Real> u, double rounding) {
  const Vec<Real> q = u - lens.larger_center;
  return (!lens.two_arcs) | (dot(q, q) <= lens.larger_radius * lens.larger_radius * Real(rounding));
}

template <typename Real>
AVO_KERNEL Vec<Real> corner_towards(const Lens<Real>& lens, Vec<Real> p) {
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
AVO_KERNEL LensPoint<Real> nearest(const Lens<Real>& lens, Vec<Real> p) {
  constexpr double rounding = kRoundingOfSquares;
  const Mask<Real> inside_smaller = in_smaller(lens, p, 1.0);
  const Mask<Real> inside_larger = in_larger(lens, p, 1.0);
  const Mask<Real> moved = !(inside_smaller & inside_larger);
  if (!any(moved & lens.ordinary)) return {p, moved};
  Mask<Real> open = moved;
  Vec<Real> point = p;
  const Vec<Real> on_smaller = (lens.radius / norm(p)) * p;
  Mask<Real> here = open & !inside_smaller & in_larger(lens, on_smaller, rounding);
  point = select(here, on_smaller, point);
  open = open & !here;
  if (!any(open & lens.ordinary)) return {point, moved};
  const Vec<Real> q = p - lens.larger_center;
  const Vec<Real> on_larger = lens.larger_center + (lens.larger_radius / norm(q)) * q;
  here = open & !inside_larger & in_smaller(lens, on_larger, rounding);
  point = select(here, on_larger, point);
  open = open & !here;
  if (!any(open & lens.ordinary)) return {point, moved};
  return {select(open, corner_towards(lens, p), point), moved};
}

template <typename Real>
AVO_KERNEL Vec<Real> farthest_along(const Lens<Real>& lens, Vec<Real> direction) {
  constexpr double rounding = kRoundingOfSquares;
  const Vec<Real> n = direction / norm(direction);
  const Vec<Real> on_smaller = lens.radius * n;
  const Mask<Real> smaller = in_larger(lens, on_smaller, rounding);
  if (!any(!smaller)) return on_smaller;
  const Vec<Real> on_larger = lens.larger_center + lens.larger_radius * n;
  const Mask<Real> larger = in_smaller(lens, on_larger, rounding);
  return select(smaller, on_smaller, select(larger, on_larger, corner_towards(lens, n)));
}

/// Back into the discs, the smaller one last.
template <typename Real>
AVO_KERNEL Vec<Real> absolute_point(const Lens<Real>& lens, const Discs<Real>& discs,
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
