// SPDX-License-Identifier: Apache-2.0
// The half-plane of the horn case, by lemma 8 of docs/half_plane.md. The near corners of the hull
// are the crossings Q of the near side with the circle |w| = R, and the disc of τ. The half-plane
// is that of least support among the edges between them. Here the near side crosses the circle at
// most three times.
#ifndef AVO_OBSTACLES_HORN_HULL_KERNEL_H
#define AVO_OBSTACLES_HORN_HULL_KERNEL_H

#include <array>
#include <cstddef>
#include <limits>

#include "obstacles/horn_follow_kernel.h"

AVO_BEGIN_KERNELS

// Normals on the left of the direction from a to b, and of the line to the tangent point of a disc.
template <typename Real>
AVO_KERNEL Vec<Real> chord_normal(Vec<Real> a, Vec<Real> b) {
  const Vec<Real> m = b - a;
  return inverse(norm(m)) * perpendicular(m);
}
template <typename Real>
AVO_KERNEL Vec<Real> tangent_normal(Vec<Real> a, Vec<Real> center, Real radius) {
  const Vec<Real> m = center - a;
  const Real m2 = dot(m, m), per_m2 = inverse(m2);
  const Real l = sqrt(max(Real(0.0), m2 - radius * radius));
  return {(-radius * m.x - l * m.y) * per_m2, (-radius * m.y + l * m.x) * per_m2};
}

template <typename Real>
struct HornPlane {
  using Mask = decltype(Real() < Real());
  SupportLine<Real> plane;
  Mask settled;  // if false, the next search is needed: see solve_horn() in half_plane.cpp
  Mask free;     // the obstacle is out of reach
};

/// The corners of the hull on its near side, and the least supports among its edges.
template <typename Real, std::size_t kCrossings>
struct Hull {
  using Mask = decltype(Real() < Real());
  std::array<Vec<Real>, kCrossings> crossing;  // the corners Q, by time
  std::array<Mask, kCrossings> has_crossing;
  Vec<Real> center, near, far;  // of the disc of τ; its corners
  Real radius, R;
  Mask disc_in_reach, is_cut;

  // The support of the points within reach: where the disc's extreme point is out of reach, its
  // corners replace it.
  AVO_KERNEL Real support(Vec<Real> n) const {
    const Real none = Real(-std::numeric_limits<double>::infinity());
    const Vec<Real> extreme = center + radius * n;
    Real h =
        select(disc_in_reach & (dot(extreme, extreme) <= R * R), dot(n, center) + radius, none);
    for (std::size_t k = 0; k < kCrossings; ++k) {
      h = max(h, select(has_crossing[k], dot(n, crossing[k]), none));
    }
    const Real corners = max(dot(n, near), dot(n, far));
    return max(h, select(is_cut, corners, none));
  }
  // Keeps the edge with the normal n if its support is less.
  AVO_KERNEL void offer(Vec<Real> n, Mask valid, SupportLine<Real>& best) const {
    const Real h = support(n);
    const auto better = valid & (h < best.h);
    best.n.x = select(better, n.x, best.n.x);
    best.n.y = select(better, n.y, best.n.y);
    best.h = select(better, h, best.h);
  }
  // The edges from one Q: its tangent to the disc, its chords to later Qs, and its chords to the
  // points where the circle cuts the disc.
  AVO_KERNEL void offer_edges_from(std::size_t k, SupportLine<Real>& best) const {
    const Vec<Real> q = crossing[k], to_disc = q - center;
    const auto outside = dot(to_disc, to_disc) > radius * radius;
    offer(tangent_normal(q, center, radius), disc_in_reach & has_crossing[k] & outside, best);
    for (std::size_t j = k + 1; j < kCrossings; ++j) {
      const Vec<Real> b = crossing[j];
      const auto valid = has_crossing[k] & has_crossing[j] & (dot(b - q, b - q) > Real(0.0));
      if (any(valid)) offer(chord_normal(q, b), valid, best);
    }
    if (any(is_cut & has_crossing[k])) {
      offer(chord_normal(q, near), is_cut & has_crossing[k], best);
      offer(chord_normal(q, far), is_cut & has_crossing[k], best);
    }
  }
};

/// Of the edges of all Qs, and of the tangent of the disc towards w = 0.
template <typename Real, std::size_t kCrossings>
AVO_KERNEL SupportLine<Real> least_support(const Hull<Real, kCrossings>& hull) {
  const Real infinity = Real(std::numeric_limits<double>::infinity());
  SupportLine<Real> best{{Real(0.0), Real(0.0)}, infinity};
  const Real length = norm(hull.center);
  hull.offer(-inverse(length) * hull.center, hull.disc_in_reach, best);
  for (std::size_t k = 0; k < kCrossings; ++k) {
    if (any(hull.has_crossing[k])) hull.offer_edges_from(k, best);
  }
  return best;
}

/// Sets the disc of τ; the crossings remain to be set.
template <std::size_t kCrossings, typename Real>
AVO_KERNEL Hull<Real, kCrossings> hull_of(const Horn<Real>& horn, const At<Real>& end,
                                          const ResponseAt& horizon_end) {
  const Local<Real>& pair = horn.pair;
  const Vec<Real> x = pair.x(end);
  Hull<Real, kCrossings> hull;
  hull.R = pair.R;
  hull.center = Real(-1.0 / horizon_end.gain) * x;
  hull.radius = pair.r * Real(1.0 / horizon_end.gain);
  hull.disc_in_reach = norm(x) - pair.r < pair.R * end.gain;
  hull.is_cut = hull.disc_in_reach & (norm(hull.center) + hull.radius > pair.R);
  hull.near = hull.far = hull.center;
  if (any(hull.is_cut)) {
    const TwoPoints<Real> corners = circle_points(horn, end);
    hull.near = corners.near, hull.far = corners.far;
  }
  return hull;
}

/// Lemma 7: at most one crossing, as SearchSpan says.
template <typename Real>
AVO_KERNEL HornPlane<Real> horn_crossed_once(const Local<Real>& pair, const ResponseAt& horizon_end,
                                             const ResponseTable& table) {
  const Horn<Real> shape = horn_of(pair);
  const At<Real> end = constant<Real>(horizon_end);
  const SearchSpan<Real> span = passage(shape, horizon_end, table);
  Hull<Real, 1> hull = hull_of<1>(shape, end, horizon_end);
  // |b| <= |x|/g: a near side that is in reach at the end has crossed
  const Real reach = pair.R * end.gain;
  auto has_crossing =
      span.crosses | ((norm(pair.x(end)) <= reach) & (shape.speed <= pair.R * end.rate));
  if (any(!has_crossing)) {
    const auto crossed = near_side(shape, end, table).b2 <= reach * reach;
    has_crossing = (has_crossing | crossed) & (span.first < end.time);
  }
  hull.has_crossing[0] = has_crossing;
  const HornCrossing<Real> cross = crossing(
      shape, {span.first, span.last, first_time(shape, table), Real(1.0), Real(kTimeTolerance)},
      table, has_crossing & span.once & span.ordinary);
  hull.crossing[0] = circle_points(shape, at(table, cross.time)).near;
  HornPlane<Real> result;
  result.plane = least_support(hull);
  result.free = !(hull.disc_in_reach | has_crossing);
  result.settled =
      span.once & span.ordinary &
      ((hull.disc_in_reach & ((cross.tangential >= Real(0.0)) | (!has_crossing))) | result.free);
  return result;
}

/// Lemma 9: as many crossings as follow() finds. b is the near end of its disc's arc on the circle
/// where `tangential` is positive. If it is the far end at the first crossing, near contact, the
/// disc of that time has corners of its own. The general search handles that case.
template <typename Real>
AVO_KERNEL HornPlane<Real> horn_crossed_often(const Local<Real>& pair,
                                              const ResponseAt& horizon_end,
                                              const ResponseTable& table) {
  const Horn<Real> shape = horn_of(pair);
  const Crossings<Real> crossings = follow(shape, passage(shape, horizon_end, table), table);
  auto hull = hull_of<kMostCrossings>(shape, constant<Real>(horizon_end), horizon_end);
  hull.has_crossing = crossings.present;
  auto regular = crossings.complete;
  for (std::size_t k = 0; k < kMostCrossings; ++k) {
    const auto wanted = crossings.present[k] & crossings.complete;
    hull.crossing[k] = hull.center;
    if (!any(wanted)) continue;
    const HornCrossing<Real> cross = crossing(shape, crossings.between[k], table, wanted);
    const TwoPoints<Real> ends = circle_points(shape, at(table, cross.time));
    const auto on_near_end = cross.tangential >= Real(0.0);
    hull.crossing[k] = select(on_near_end, ends.near, ends.far);
    if (k == 0) regular = regular & (on_near_end | (!crossings.present[k]));
  }
  HornPlane<Real> result;
  result.plane = least_support(hull);
  result.free = !(hull.disc_in_reach | crossings.present[0]);
  const Real infinity = Real(std::numeric_limits<double>::infinity());
  result.settled = regular & (result.free | (result.plane.h < infinity));
  return result;
}

template <Crossed crossed, typename Real>
AVO_KERNEL HornPlane<Real> horn(const Local<Real>& pair, const ResponseAt& horizon_end,
                                const ResponseTable& table) {
  if constexpr (crossed == Crossed::once) return horn_crossed_once(pair, horizon_end, table);
  if constexpr (crossed == Crossed::often) return horn_crossed_often(pair, horizon_end, table);
}

AVO_END_KERNELS

#endif  // once per pass
