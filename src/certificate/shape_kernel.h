// SPDX-License-Identifier: Apache-2.0
// The common direction of a pair on one interval, in the plane and in space: docs/certificate.md,
// "Braking trajectories", and docs/space.md, "The nearest point".
#ifndef AVO_CERTIFICATE_SHAPE_KERNEL_H
#define AVO_CERTIFICATE_SHAPE_KERNEL_H

#include <algorithm>
#include <limits>

#include "certificate/braking_kernel.h"
#include "certificate/pair_constraints.h"

AVO_BEGIN_KERNELS

/// The point of a segment nearest to the origin; odd in (a, b), bit for bit.
template <typename Real, int D>
AVO_KERNEL Vec<Real, D> nearest_on_segment(Vec<Real, D> a, Vec<Real, D> b) {
  const Real zero(0.0), one(1.0);
  const Vec<Real, D> ab = b - a;
  const Real squared = dot(ab, ab);
  const Real part = -dot(a, ab) / select(squared > zero, squared, one);
  return a + min(max(part, zero), one) * ab;
}

/// The direction of the point of the triangle's edges nearest to the origin; 0 where that point is
/// the origin. Whether the origin lies inside is not tested, so that no sign of rounding noise
/// decides anything. Any direction makes a sound constraint, and its distance gives the value of
/// the constraint.
template <typename Real>
AVO_KERNEL Vec<Real> normal_of(const PackPoints<Real>& q, const PairShape<2>&) {
  const Real zero(0.0), one(1.0);
  Vec<Real> nearest = nearest_on_segment(q.start, q.middle);
  Real squared = dot(nearest, nearest);
  for (const Vec<Real>& other :
       {nearest_on_segment(q.middle, q.end), nearest_on_segment(q.end, q.start)}) {
    const Real of_other = dot(other, other);
    const auto nearer = of_other < squared;
    nearest = select(nearer, other, nearest);
    squared = select(nearer, of_other, squared);
  }
  const Real length = sqrt(squared);
  const auto has_length = length > zero;
  const Real per_length = one / select(has_length, length, one);
  return select(has_length, per_length * nearest, {zero, zero});
}

// ---- the plane: nothing but discs

AVO_KERNEL bool has_wash(const PairShape<2>&) {
  return false;
}
template <typename Real>
AVO_KERNEL Real distance_to(Vec<Real> q, const PairShape<2>&) {
  return norm(q);
}
/// The length of a path and of the shape that it keeps off, m.
template <typename Real>
AVO_KERNEL Real with_shape(Real length, const PairShape<2>&) {
  return length;
}
template <typename Real>
AVO_KERNEL Real longest(Real own_length, const PairShape<2>&) {
  return own_length;
}
template <typename Real>
AVO_KERNEL Vec<Real> in_own_space(Vec<Real> n, const PairShape<2>&) {
  return n;
}
AVO_KERNEL Vec2 own_direction(Vec2 direction, const PairShape<2>&) {
  return direction;
}
/// factor |n| for a unit normal n.
template <typename Real>
AVO_KERNEL Real times_length(Real factor, Vec<Real>, const PairShape<2>&) {
  return factor;
}

// ---- space: balls and downwash, limits that differ along the vertical

AVO_KERNEL bool has_wash(const PairShape<3>& shape) {
  return shape.has_wash();
}

/// The largest n . x of the points x of the segment that p_A - p_B keeps off, m.
template <typename Real>
AVO_KERNEL Real support(Vec<Real, 3> n, const PairShape<3>& shape) {
  return max(n.z * Real(shape.up), -(n.z * Real(shape.down)));
}

/// The distance of q from that segment, m.
template <typename Real>
AVO_KERNEL Real distance_to(Vec<Real, 3> q, const PairShape<3>& shape) {
  return norm(Vec<Real, 3>{q.x, q.y, q.z - min(max(q.z, Real(-shape.down)), Real(shape.up))});
}

template <typename Real>
AVO_KERNEL Real with_shape(Real length, const PairShape<3>& shape) {
  return length + Real(shape.up + shape.down);
}

/// The largest length in space of what is that long in A's own space.
template <typename Real>
AVO_KERNEL Real longest(Real own_length, const PairShape<3>& shape) {
  return own_length * Real(std::max(shape.vertical, 1.0));
}

/// m with n . x = m . x' for each x, where x' is x in A's own space: z divided by e_A.
template <typename Real>
AVO_KERNEL Vec<Real, 3> in_own_space(Vec<Real, 3> n, const PairShape<3>& shape) {
  return {n.x, n.y, Real(shape.vertical) * n.z};
}
AVO_KERNEL Vec3 own_direction(Vec3, const PairShape<3>& shape) {
  return shape.own_direction;
}
template <typename Real>
AVO_KERNEL Real times_length(Real factor, Vec<Real, 3> own_normal, const PairShape<3>&) {
  return factor * norm(own_normal);
}

/// A direction, and the distance that it proves, m.
template <typename Real>
struct PackCandidate {
  Vec<Real, 3> n;
  Real distance;
};

/// Replaces the best direction by that of c, where the direction of c proves a larger distance.
template <typename Real>
AVO_KERNEL void consider(Vec<Real, 3> c, const PackPoints<Real, 3>& q, const PairShape<3>& shape,
                         PackCandidate<Real>& best) {
  const Real length = norm(c);
  const auto has_length = length > Real(0.0);
  const Vec<Real, 3> n = (Real(1.0) / select(has_length, length, Real(1.0))) * c;
  const Real least = min(min(dot(n, q.start), dot(n, q.middle)), dot(n, q.end));
  const Real distance = least - support(n, shape);
  const auto better = has_length & (distance > best.distance);
  best.n = select(better, n, best.n);
  best.distance = select(better, distance, best.distance);
}

/// Considers the nearest points of the edges of a triangle and, with kFace, of its plane.
template <bool kFace, typename Real>
AVO_KERNEL void consider_triangle(const PackPoints<Real, 3>& t, const PackPoints<Real, 3>& q,
                                  const PairShape<3>& shape, PackCandidate<Real>& best) {
  consider(nearest_on_segment(t.start, t.middle), q, shape, best);
  consider(nearest_on_segment(t.middle, t.end), q, shape, best);
  consider(nearest_on_segment(t.end, t.start), q, shape, best);
  if constexpr (kFace) {
    const Real zero(0.0), one(1.0);
    const Vec<Real, 3> m = cross(t.middle - t.start, t.end - t.start);
    // the side of the triangle that the origin is on; 0 would be the same side for both robots
    const Real side = dot(m, t.start);
    const Real sign = select(side > zero, one, select(side < zero, -one, zero));
    consider(sign * m, q, shape, best);
  }
}

/// Whether A is above B on the interval: odd in q. Both are false where all heights are 0.
template <typename Real>
struct PackHeights {
  decltype(Real() < Real()) above, below;
};
template <typename Real>
AVO_KERNEL PackHeights<Real> heights_of(const PackPoints<Real, 3>& q) {
  const Real zero(0.0), middle = q.middle.z, ends = q.start.z + q.end.z, start = q.start.z;
  const auto no_middle = !((middle > zero) | (middle < zero));
  const auto no_ends = no_middle & !((ends > zero) | (ends < zero));
  return {(middle > zero) | (no_middle & (ends > zero)) | (no_ends & (start > zero)),
          (middle < zero) | (no_middle & (ends < zero)) | (no_ends & (start < zero))};
}

/// The direction that proves the largest distance of the triangle q from the pair's segment, among
/// the directions of a few points. It is 0 where all points are the origin. The direction of the
/// nearest point is among them, and no direction proves more than that. So no sign of rounding
/// noise decides anything. Odd, bit for bit, where q is negated and the pair's shape turned upside
/// down.
template <typename Real>
AVO_KERNEL Vec<Real, 3> normal_of(const PackPoints<Real, 3>& q, const PairShape<3>& shape) {
  const Real zero(0.0);
  PackCandidate<Real> best{zero_vector<Real, 3>(), Real(-std::numeric_limits<double>::infinity())};
  if (!shape.has_wash()) {
    consider_triangle<true>(q, q, shape, best);
    return best.n;
  }
  const auto flat = [zero](const Vec<Real, 3>& a) { return Vec<Real, 3>{a.x, a.y, zero}; };
  consider_triangle<false>(PackPoints<Real, 3>{flat(q.start), flat(q.middle), flat(q.end)}, q,
                           shape, best);
  // Where two directions prove the same distance, the first one counts. So the order of the ends of
  // the segment has to be the same for both robots. Where all heights are 0, the best one is flat.
  const PackHeights<Real> heights = heights_of(q);
  const Vec<Real, 3> best_flat = best.n;
  const Real to_up(-shape.up), to_down(shape.down);
  for (const Real by :
       {select(heights.above, to_up, to_down), select(heights.above, to_down, to_up)}) {
    const auto moved = [by](const Vec<Real, 3>& a) { return Vec<Real, 3>{a.x, a.y, a.z + by}; };
    consider_triangle<true>(PackPoints<Real, 3>{moved(q.start), moved(q.middle), moved(q.end)}, q,
                            shape, best);
  }
  return select(heights.above | heights.below, best.n, best_flat);
}

AVO_END_KERNELS

#endif  // once per pass
