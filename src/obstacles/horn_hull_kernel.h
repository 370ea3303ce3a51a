// SPDX-License-Identifier: Apache-2.0
// The horn case: where its near side crosses the circle |w| = R once at most, the half-plane from
// that corner of the hull and those of the disc of τ.
// Included after horn_walk_kernel.h, once per instruction set.

// Normal on the left of the way from a to b, and to the tangent point of a disc.
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
  Plane<Real> plane;
  Mask settled;  // else look more closely, and then by the general search (horn.cpp)
  Mask free;     // the obstacle is out of reach
};

/// The corners of the hull on its near side, and the least supports among its edges.
template <typename Real>
struct Hull {
  using Mask = decltype(Real() < Real());
  Vec<Real> center, crossing, near, far;  // of the disc of τ; the corner Q; the disc's corners
  Real radius, R;
  Mask disc_in_reach, has_crossing, is_cut;

  // Of the points within reach: where the disc's extreme point is not, its corners take its place.
  AVO_KERNEL Real support(Vec<Real> n) const {
    const Real none = Real(-std::numeric_limits<typename Real::Number>::infinity());
    const Vec<Real> extreme = center + radius * n;
    Real h =
        select(disc_in_reach & (dot(extreme, extreme) <= R * R), dot(n, center) + radius, none);
    h = max(h, select(has_crossing, dot(n, crossing), none));
    const Real corners = max(dot(n, near), dot(n, far));
    return max(h, select(is_cut, corners, none));
  }
  AVO_KERNEL void offer(Vec<Real> n, Mask valid, Plane<Real>& best) const {
    const Real h = support(n);
    const auto better = valid & (h < best.h);
    best.n.x = select(better, n.x, best.n.x);
    best.n.y = select(better, n.y, best.n.y);
    best.h = select(better, h, best.h);
  }
};

template <typename Real>
AVO_KERNEL Plane<Real> least_support(const Hull<Real>& hull) {
  using Number = typename Real::Number;
  const Real infinity = Real(std::numeric_limits<Number>::infinity());
  Plane<Real> best{{Real(0.0), Real(0.0)}, infinity};
  const Real length = norm(hull.center);
  hull.offer(-inverse(length) * hull.center, hull.disc_in_reach, best);
  const Vec<Real> to_disc = hull.crossing - hull.center;
  const auto outside = dot(to_disc, to_disc) > hull.radius * hull.radius;
  hull.offer(tangent_normal(hull.crossing, hull.center, hull.radius),
             hull.disc_in_reach & hull.has_crossing & outside, best);
  if (any(hull.is_cut & hull.has_crossing)) {
    hull.offer(chord_normal(hull.crossing, hull.near), hull.is_cut & hull.has_crossing, best);
    hull.offer(chord_normal(hull.crossing, hull.far), hull.is_cut & hull.has_crossing, best);
  }
  return best;
}

template <typename Real>
AVO_KERNEL HornPlane<Real> horn(const Local<Real>& pair, const ResponseAt& horizon_end,
                                const ResponseTable<typename Real::Number>& table, Look look) {
  const Horn<Real> shape = horn_of(pair);
  const At<Real> end = constant<Real>(horizon_end);
  Passage<Real> way = passage(shape, horizon_end, table);
  if (look == Look::closely) walk(shape, table, way);
  const Vec<Real> x = pair.x(end);
  const Real length = norm(x);

  Hull<Real> hull;
  hull.R = pair.R;
  hull.center = Real(-1.0 / horizon_end.gain) * x;
  hull.radius = pair.r * Real(1.0 / horizon_end.gain);
  hull.disc_in_reach = length - pair.r < pair.R * end.gain;
  // |b| <= |x|/g: whoever is in reach at the end has crossed
  hull.has_crossing =
      way.crosses | ((length <= pair.R * end.gain) & (shape.speed <= pair.R * end.rate));
  if (any(!hull.has_crossing)) {
    const Real reach = pair.R * end.gain;
    const auto crossed = near_side(shape, end, table).b2 <= reach * reach;
    hull.has_crossing = (hull.has_crossing | crossed) & (way.first < end.time);
  }
  const Crossing<Real> cross = crossing(shape,
                                        {way.first, way.last, first_time(shape, table), Real(1.0),
                                         Real(kTimeTolerance<typename Real::Number>)},
                                        table, hull.has_crossing & way.once & way.ordinary);
  hull.crossing = circle_points(shape, at(table, cross.time)).near;
  hull.is_cut = hull.disc_in_reach & (norm(hull.center) + hull.radius > pair.R);
  hull.near = hull.far = hull.crossing;
  if (any(hull.is_cut)) {
    const TwoPoints<Real> corners = circle_points(shape, end);
    hull.near = corners.near, hull.far = corners.far;
  }
  HornPlane<Real> result;
  result.plane = least_support(hull);
  result.free = !(hull.disc_in_reach | hull.has_crossing);
  result.settled =
      way.once & way.ordinary &
      ((hull.disc_in_reach & ((cross.tangential >= Real(0.0)) | (!hull.has_crossing))) |
       result.free);
  return result;
}
