// SPDX-License-Identifier: Apache-2.0
// The horn case where the near side crosses the circle |w| = R once at most: that is nearly always.
// Included into a namespace that has half_plane_kernel.h, once per instruction set.

/// The near side at one time: the point b = (r n - x)/g, n . y = r, at which it touches the disc.
/// With x = y + (t - s) v and t - s = g/g', b has the components -n . v/g' along n and `tangential`
/// across it. It moves across n only, by -cusp/(g l) with l² = |y|² - r²: so |b| turns where
/// `tangential` or `cusp` changes its sign, and falls at first, when both are positive.
template <typename Real>
struct NearSide {
  At<Real> at;
  Vec<Real> b;            // m/s
  Real length;            // |b|
  Real tangential, cusp;  // m/s, m²/s; -d|b|/dt = tangential · cusp/(g l |b|)
  Real gain_l;            // g l
};

template <typename Real>
struct Horn {
  Local<Real> pair;
  Real speed, gap, along, v2;  // |v|, |p|² - r², p . v, |v|²

  // |p + t v|² - r²: of small terms in contact, which single precision leaves to double
  AVO_KERNEL Real beyond(Real t) const {
    if constexpr (kSingle<Real>) {
      const Real x = norm(Vec<Real>{pair.d + t * pair.v.x, t * pair.v.y});
      return (x - pair.r) * (x + pair.r);
    }
    return gap + t * (Real(2.0) * along + t * v2);
  }
};

template <typename Real>
AVO_KERNEL Horn<Real> horn_of(const Local<Real>& pair) {
  return {pair, norm(pair.v), (pair.d - pair.r) * (pair.d + pair.r), pair.d * pair.v.x,
          dot(pair.v, pair.v)};
}

template <typename Real>
AVO_KERNEL NearSide<Real> near_side(const Horn<Real>& horn, const At<Real>& at,
                                    const ResponseTable<typename Real::Number>& table) {
  const Real r = horn.pair.r;
  const Vec<Real> y = horn.pair.y(at), v = horn.pair.v;
  const Real l2 = max(Real(0.0), horn.beyond(at.lag)), l = sqrt(l2);
  const Real per_y2 = inverse(dot(y, y)), per_gain = inverse(at.gain);
  const Vec<Real> n = {(r * y.x - l * y.y) * per_y2, (r * y.y + l * y.x) * per_y2};
  const Real n_v = dot(n, v);
  const Real normal = -n_v * at.per_rate;
  const Real tangential = l * per_gain - dot(perpendicular(n), v) * at.per_rate;
  const Real lag_rate =
      at.gain * (Real(1.0) - at.rate) * at.per_rate * at.per_rate * Real(table.per_control_time);
  const Real cusp = l2 * at.rate * per_gain - r * lag_rate * n_v;
  return {at,
          normal * n + tangential * perpendicular(n),
          sqrt(normal * normal + tangential * tangential),
          tangential,
          cusp,
          at.gain * l};
}

template <typename Real>
struct TwoPoints {
  Vec<Real> near, far;
};

/// Where the circle |w| = R cuts the disc of one time, the end on the near side first.
template <typename Real>
AVO_KERNEL TwoPoints<Real> circle_points(const Horn<Real>& horn, const At<Real>& at) {
  const Vec<Real> x = horn.pair.x(at);
  const Real R = horn.pair.R, length = norm(x), gain_R = at.gain * R;
  // 1 + cosine in the triangle of sides gR, |x| and r, which may be thin
  const Real r = horn.pair.r;
  const Real near = gain_R - horn.beyond(at.time) / (length + r);  // r - |x| + gR
  const Real k = near * (r + (length - gain_R)) / (Real(2.0) * gain_R * length);
  const Real above = min(max(k, Real(0.0)), Real(2.0));
  const Real c = above - Real(1.0), s = sqrt(above * (Real(2.0) - above));
  const Vec<Real> u = (R * inverse(length)) * x;
  return {{c * u.x - s * u.y, c * u.y + s * u.x}, {c * u.x + s * u.y, c * u.y - s * u.x}};
}

/// When the search for the crossing begins and ends, and whether there is one only.
template <typename Real>
struct Passage {
  using Mask = decltype(Real() < Real());
  Real first, last;      // s
  Mask once;             // at most one crossing, between them
  Mask crosses;          // one for sure
  Mask ordinary;         // not in contact
  Real t_m, closest, z;  // time of the closest approach or 0, s; |p| or miss distance; p . v/|v|, m
};

// Before `first` all discs are out of reach, g being at most t²/(2 δ). |b| falls up to the closest
// approach t_m. It crosses R outwards only where `tangential` or `cusp` is negative.
//   `tangential` > 0 if l > |v| g/g', and only matters up to T where R g' >= |v| (there the robot
//      outruns the boundary). l² - (v g/g')² is concave in t: so it holds on all of [t_m, T]
//      (or [0, T]) if it does at T. Exactly it reads l (|y|² + q z) > q r b, with q = |v| g/g', the
//      miss distance b and z = |v| (s - t_m), and q <= κ |v| s, κ = (τ - s(τ))/s(τ). Receding,
//      |y|² >= 2 b z and |v| s <= z: 2 l_0 >= κ r suffices. Else, m = |v| t_m, past the closest
//      point of y: l_m >= κ r and b l_m >= 2 κ m r suffice; before it |y|² + q z is at least
//      b² - m² κ²/(4 (1 + κ)), which is b²/2 or more if b >= m and κ <= 2.7.
//   `cusp` > 0 if l² > |v| r s' g/g', and s' g/g' is at most s/2 and 0.271 δ. Receding, l² grows
//      at least as (l_0 + z_0 |v|s...): l_0 + p . v/|v| > r/4 suffices. Else, with the miss
//      distance b, l_m² > r²/16 + r |v| t_m/2, or b l_m >= 0.353 δ r |v|: n . v/|v| is
//      (r z + l b)/(z² + b²), for which l² > c n . v/|v| at all z if b l_m >= 1.3 c.
// Else, if the closest approach is in reach, |b| <= |x|/g <= R from there on.
template <typename Real>
AVO_KERNEL Passage<Real> passage(const Horn<Real>& horn, const ResponseAt& horizon_end,
                                 const ResponseTable<typename Real::Number>& table) {
  const double kappa = (horizon_end.time - horizon_end.lag) / horizon_end.lag;
  const Local<Real>& pair = horn.pair;
  const Real delta = table.control_time, tau = table.end, zero = Real(0.0);
  const Real per_speed = Real(1.0) / max(horn.speed, Real(kSlowest<typename Real::Number>));
  const Real z = pair.v.x * pair.d * per_speed;  // p . v/|v|, m
  const Real t_m = max(-z * per_speed, zero);
  const auto closing = z < zero;
  const Real closest = select(closing, pair.d * pair.v.y * per_speed, pair.d);
  const Real clear = closest - pair.r, l2 = clear * (closest + pair.r), l = sqrt(max(l2, zero));

  const Real part = horn.speed / pair.R, half = Real(1.0) - Real(0.5) * part;
  const Real root = half * half - part * part * Real(1.0 / 3.0);
  const Real outrun = delta * Real(2.0) * part / (half + sqrt(max(root, zero)));
  const At<Real> at_T = at(table, select((root >= zero) & (outrun < tau), outrun, tau));
  const Real lead = at_T.gain * at_T.per_rate;
  const Real kappa_r = Real(kappa) * pair.r;
  auto no_turn =
      (horn.beyond(at_T.lag) >= horn.v2 * lead * lead) | ((!closing) & (Real(2.0) * l >= kappa_r));
  if (kappa <= 2.7) {
    no_turn = no_turn | (closing & (closest >= -z) & (l >= kappa_r) &
                         (closest * l >= Real(-2.0) * z * kappa_r));
  }
  const Real r_v = pair.r * horn.speed;
  const auto no_cusp =
      ((!closing) & (l + z > Real(0.25) * pair.r)) |
      (closing & ((closest * l >= Real(0.353) * delta * r_v) |
                  (l2 > pair.r * pair.r * Real(1.0 / 16.0) + Real(0.5) * r_v * t_m)));

  const At<Real> at_m = at(table, min(t_m, tau));
  const auto in_reach =
      closing & (t_m <= tau) & (closest <= pair.R * at_m.gain) & (horn.speed <= pair.R * at_m.rate);
  const Real first = sqrt(Real(2.0) * delta * max(clear, zero) / pair.R);
  return {first,
          select(in_reach, t_m, tau),
          in_reach | (no_turn & no_cusp),
          in_reach,
          clear > Real(kContact<typename Real::Number>) * pair.r,
          t_m,
          closest,
          z};
}

/// See horn_walk_kernel.h.
template <typename Real>
AVO_KERNEL void walk(const Horn<Real>& horn, const ResponseTable<typename Real::Number>& table,
                     Passage<Real>& passage);

/// Where |b| = R, falling: Newton's iteration for sqrt(R/|b|), which is nearly linear in time,
/// guarded by bisection. Means something in the lanes that are wanted.
template <typename Real>
AVO_KERNEL NearSide<Real> crossing(const Horn<Real>& horn, const Passage<Real>& passage,
                                   const ResponseTable<typename Real::Number>& table,
                                   decltype(Real() < Real()) wanted) {
  const Real R = horn.pair.R, per_R = Real(1.0) / R;
  Real low = passage.first, high = passage.last;
  Real t = passage.first + passage.first * passage.first * Real(table.per_control_time / 6.0);
  t = select((t > low) & (t < high), t, Real(0.5) * (low + high));
  auto active = wanted;
  NearSide<Real> side;
  for (int i = 0; i < kMaxIterations; ++i) {
    side = near_side(horn, at(table, t), table);
    const auto outside = side.length > R;
    low = select(outside, t, low);
    high = select(outside, high, t);
    const Real excess = sqrt(side.length * per_R) - Real(1.0);
    const Real fall = side.tangential * side.cusp;
    const auto falls = fall > Real(0.0);
    const Real newton = t + Real(2.0) * excess * side.length * side.length * side.gain_l /
                                select(falls, fall, Real(1.0));
    active =
        active & ((!falls) | (abs(newton - t) > Real(kTimeTolerance<typename Real::Number>) * t));
    const Real next =
        select(falls & (newton > low) & (newton < high), newton, Real(0.5) * (low + high));
    if (!any(active)) break;
    t = select(active, next, t);
  }
  return side;
}

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
    Real h = select(disc_in_reach & (norm(extreme) <= R), dot(n, center) + radius, none);
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
    const auto crossed = near_side(shape, end, table).length <= pair.R;
    hull.has_crossing = (hull.has_crossing | crossed) & (way.first < end.time);
  }
  const NearSide<Real> side =
      crossing(shape, way, table, hull.has_crossing & way.once & way.ordinary);
  const TwoPoints<Real> ends = circle_points(shape, side.at);
  const Vec<Real> to_near = ends.near - side.b, to_far = ends.far - side.b;
  const auto on_near_end = dot(to_near, to_near) <= dot(to_far, to_far);
  hull.crossing = ends.near;
  hull.is_cut = hull.disc_in_reach & (norm(hull.center) + hull.radius > pair.R);
  hull.near = hull.far = hull.crossing;
  if (any(hull.is_cut)) {
    const TwoPoints<Real> corners = circle_points(shape, end);
    hull.near = corners.near, hull.far = corners.far;
  }
  HornPlane<Real> result;
  result.plane = least_support(hull);
  result.free = !(hull.disc_in_reach | hull.has_crossing);
  result.settled = way.once & way.ordinary &
                   ((hull.disc_in_reach & (on_near_end | (!hull.has_crossing))) | result.free);
  return result;
}
