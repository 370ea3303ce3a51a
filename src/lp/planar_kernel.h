// SPDX-License-Identifier: Apache-2.0
// Eq. (23) in the plane, one robot per lane: one half-plane after the other, one line at a time.
// Each lane takes the half-plane that it violates most, until the last lane is done. The best point
// then lies on the boundary of this half-plane, and only those taken before limit it there.
#ifndef AVO_LP_PLANAR_KERNEL_H
#define AVO_LP_PLANAR_KERNEL_H

#include <cstddef>
#include <limits>

#include "lp/lens_kernel.h"

AVO_BEGIN_KERNELS
namespace planar {

template <typename Real>
struct Plane {
  Vec<Real> normal;
  Real offset;
};

/// The offset of an absent half-plane.
template <typename Real>
AVO_KERNEL Real none() {
  return -std::numeric_limits<double>::infinity();
}

template <typename Real>
AVO_KERNEL Real violation(const Plane<Real>& plane, Vec<Real> u) {
  return plane.offset - dot(plane.normal, u);
}

/// Half-planes relative to LensOf::origin, of lanes first .. first + Real::kLanes. Normals may have
/// any length if Goal::direction is not zero: a violation is in the unit of the offset.
template <typename Real, typename Row>
struct Planes {
  Row* rows;
  std::size_t first;
  std::size_t count;

  AVO_KERNEL Plane<Real> operator[](std::size_t i) const {
    const Row& row = rows[i];
    return {{Real::load(row.n_x + first), Real::load(row.n_y + first)},
            Real::load(row.relative + first)};
  }
  AVO_KERNEL void add(const Plane<Real>& plane) {
    Row& row = rows[count++];
    plane.normal.x.store(row.n_x + first);
    plane.normal.y.store(row.n_y + first);
    plane.offset.store(row.relative + first);
  }
};

/// The point nearest `preferred`; or, if `direction` is not zero, the farthest point along it, and
/// among equals the one nearest `preferred`.
template <typename Real>
struct Goal {
  Vec<Real> preferred, direction;
};

template <typename Real>
struct PlaneEdge {
  Vec<Real> normal, along;
  Real offset;
};

/// The remaining part of a line, lo <= t <= hi.
template <typename Real>
struct LineRange {
  Real lo, hi;
  Mask<Real> left;
};

/// Both ends in factors (r - o)(r + o): r² - o² would lose half the digits of a short chord.
template <bool kRelaxed, typename Real>
AVO_KERNEL LineRange<Real> clip_to_discs(const LensOf<Real>& lens, const PlaneEdge<Real>& line) {
  const Real zero = 0.0;
  const Real slack = kRelaxed ? Real(0.5) * lens.tolerance : zero;
  const Real gap = lens.radius - abs(line.offset);
  const Real half = slack + sqrt(max(gap, zero) * (lens.radius + abs(line.offset)));
  LineRange<Real> range{-half, half, gap >= -slack};
  if (!any(lens.two_arcs)) return range;

  const Real larger_slack = kRelaxed ? Real(0.5) * lens.larger_tolerance : zero;
  const Real offset = abs(line.offset - dot(line.normal, lens.larger_center));
  const Real larger_gap = lens.larger_radius - offset;
  const Real larger_half =
      larger_slack + sqrt(max(larger_gap, zero) * (lens.larger_radius + offset));
  const Real middle = dot(line.along, lens.larger_center);
  const Real lo = middle - larger_half, hi = middle + larger_half;
  range.lo = select(lens.two_arcs & (lo > range.lo), lo, range.lo);
  range.hi = select(lens.two_arcs & (hi < range.hi), hi, range.hi);
  range.left = range.left & ((!lens.two_arcs) | (larger_gap >= -larger_slack));
  return range;
}

/// Along the line, a plane is t * slope >= excess. Where the whole lens cannot change t * slope by
/// more than rounding, the two lines are parallel and only the excess counts.
template <bool kRelaxed, typename Real, typename Row>
AVO_KERNEL LineRange<Real> clip(const LensOf<Real>& lens, const PlaneEdge<Real>& line,
                                const Planes<Real, Row>& planes) {
  const Real zero = 0.0;
  const Real slack = kRelaxed ? Real(0.5) * lens.tolerance : zero;
  LineRange<Real> range = clip_to_discs<kRelaxed>(lens, line);
  for (std::size_t j = 0; j < planes.count; ++j) {
    const Plane<Real> plane = planes[j];
    const Real slope = dot(plane.normal, line.along);
    const Real excess = plane.offset - line.offset * dot(plane.normal, line.normal);
    const Mask<Real> crosses = abs(slope) * lens.radius > lens.tolerance;
    const Real t = (excess - slack) / select(crosses, slope, Real(1.0));
    range.lo = select(crosses & (slope > zero) & (t > range.lo), t, range.lo);
    range.hi = select(crosses & (slope < zero) & (t < range.hi), t, range.hi);
    range.left = range.left & (crosses | (excess <= lens.tolerance));
  }
  range.left = range.left & (range.lo <= range.hi);
  return range;
}

/// The best point of the plane's boundary within the discs and all planes before it, in active
/// lanes. False where there is none. No solution is lost by rounding. Where exact clipping leaves
/// nothing (planes through one point, touching discs), all bounds are relaxed by half the
/// tolerance. Half of it, so that the point counts as inside for all later planes.
template <bool kLinear, typename Real, typename Row>
AVO_KERNEL Mask<Real> move_to_boundary(const LensOf<Real>& lens, const Planes<Real, Row>& before,
                                       const Plane<Real>& plane, const Goal<Real>& goal,
                                       Mask<Real> active, Vec<Real>& point) {
  PlaneEdge<Real> line{plane.normal, perpendicular(plane.normal), plane.offset};
  Mask<Real> moved = active;
  if constexpr (kLinear) {
    const Real length = norm(plane.normal);
    moved = active & (length > Real(0.0));
    const Real per_length = Real(1.0) / select(moved, length, Real(1.0));
    const Vec<Real> normal = per_length * plane.normal;
    line = {normal, perpendicular(normal), per_length * plane.offset};
  }
  LineRange<Real> range = clip<false>(lens, line, before);
  if (const Mask<Real> thin = moved & !range.left; any(thin)) {
    const LineRange<Real> relaxed = clip<true>(lens, line, before);
    range.lo = select(thin, relaxed.lo, range.lo);
    range.hi = select(thin, relaxed.hi, range.hi);
    moved = moved & (range.left | relaxed.left);
    line.offset = select(thin, clamp(line.offset, -lens.radius, lens.radius), line.offset);
  }
  Real t = dot(goal.preferred, line.along);
  if constexpr (kLinear) {
    const Real slope = dot(goal.direction, line.along);
    const Mask<Real> flat = abs(slope) * lens.radius <= lens.tolerance;
    t = select(flat, t, select(slope > Real(0.0), range.hi, range.lo));
  }
  t = clamp(t, range.lo, range.hi);
  point = select(moved, line.offset * line.normal + t * line.along, point);
  return moved;
}

template <typename Real>
struct Violation {
  Plane<Real> plane;
  Real by;
};

/// The larger one, the first of equals.
template <typename Real>
AVO_KERNEL Violation<Real> larger(const Violation<Real>& a, const Violation<Real>& b) {
  const Mask<Real> second = b.by > a.by;
  return {{select(second, b.plane.normal, a.plane.normal),
           select(second, b.plane.offset, a.plane.offset)},
          select(second, b.by, a.by)};
}

/// The half-plane violated by most and by more than `least`, which is set to that violation. Lanes
/// compare in pairs, since the latency of a comparison exceeds its cost; a single number would need
/// a branch prediction.
template <typename Real, typename Row>
AVO_KERNEL Plane<Real> most_violated(const Planes<Real, Row>& planes, Vec<Real> u, Real& least) {
  const auto at = [&](std::size_t i) -> Violation<Real> {
    const Plane<Real> plane = planes[i];
    return {plane, violation(plane, u)};
  };
  Violation<Real> worst{{{0.0, 0.0}, 0.0}, least};
  std::size_t i = 0;
  if constexpr (Real::kLanes > 1) {
    for (; i + 1 < planes.count; i += 2) worst = larger(worst, larger(at(i), at(i + 1)));
  }
  for (; i < planes.count; ++i) {
    const Violation<Real> next = at(i);
    if (any(next.by > worst.by)) worst = larger(worst, next);
  }
  least = worst.by;
  return worst.plane;
}

template <typename Real, typename Row>
AVO_KERNEL Mask<Real> contains(const Planes<Real, Row>& planes, const Plane<Real>& plane) {
  const auto equal = [](Real a, Real b) { return (a <= b) & (a >= b); };
  Mask<Real> moved = plane.offset < plane.offset;
  for (std::size_t j = 0; j < planes.count; ++j) {
    const Plane<Real> other_plane = planes[j];
    moved = moved |
            (equal(other_plane.offset, plane.offset) & equal(other_plane.normal.x, plane.normal.x) &
             equal(other_plane.normal.y, plane.normal.y));
  }
  return moved;
}

template <typename Real>
struct Outcome {
  Mask<Real> moved, failed;
  Plane<Real> next;  // where failed: the half-plane that leaves nothing
};

/// While others continue, a lane that has failed tests the same half-plane repeatedly. It adds to
/// `taken` the half-plane that is taken next for the least unsafe point; adding it twice does no
/// harm.
template <bool kLinear, typename Real, typename Row>
AVO_KERNEL Outcome<Real> solve_planar(const LensOf<Real>& lens, const Planes<Real, Row>& planes,
                                      const Goal<Real>& goal, Mask<Real> active,
                                      Planes<Real, Row>& taken, Vec<Real>& point) {
  const Mask<Real> nobody = active & !active;
  Outcome<Real> outcome{nobody, nobody, {{0.0, 0.0}, 0.0}};
  for (;;) {
    Real by = lens.tolerance;
    const Plane<Real> worst = most_violated(planes, point, by);
    active = active & (by > lens.tolerance);
    if (!any(active)) return outcome;
    active = active & !contains(taken, worst);
    if (!any(active)) return outcome;
    const Mask<Real> moved = move_to_boundary<kLinear>(lens, taken, worst, goal, active, point);
    const Mask<Real> stuck = active & !moved;
    outcome.next.normal = select(stuck, worst.normal, outcome.next.normal);
    outcome.next.offset = select(stuck, worst.offset, outcome.next.offset);
    outcome.failed = outcome.failed | stuck;
    outcome.moved = outcome.moved | moved;
    active = moved;
    if (!any(active)) return outcome;
    taken.add(worst);
  }
}

}  // namespace planar
AVO_END_KERNELS

#endif  // once per pass
