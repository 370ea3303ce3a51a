// SPDX-License-Identifier: Apache-2.0
// The horn case where the near side crosses the circle |w| = R once at most: that is nearly always.
// Included into a namespace that has half_plane_kernel.h, once per instruction set.

/// A pair along its relative motion. On its way μ, |v| t or |v| s, the distance squared is
/// closest² + rise(μ): of terms that do not cancel, closest being |p| or, closing in, the miss
/// distance.
template <typename Real>
struct Horn {
  Local<Real> pair;
  Real speed, per_speed, z, miss;  // |v|, 1/|v|, p . v/|v|, m; |p x v|/|v|, m
  Real closest, gap2, gap;         // closest² - r², m², and its root

  AVO_KERNEL Real rise(Real way) const {
    const Real w = way + min(z, Real(0.0));
    return w * (w + Real(2.0) * max(z, Real(0.0)));
  }
};

template <typename Real>
AVO_KERNEL Horn<Real> horn_of(const Local<Real>& pair) {
  Horn<Real> horn;
  horn.pair = pair;
  horn.speed = norm(pair.v);
  horn.per_speed = Real(1.0) / max(horn.speed, Real(kSlowest<typename Real::Number>));
  horn.z = pair.d * pair.v.x * horn.per_speed;
  horn.miss = pair.d * pair.v.y * horn.per_speed;
  horn.closest = select(horn.z < Real(0.0), horn.miss, pair.d);
  horn.gap2 = (horn.closest - pair.r) * (horn.closest + pair.r);
  horn.gap = sqrt(max(horn.gap2, Real(0.0)));
  return horn;
}

/// The near side at one time: the point b = (r n - x)/g, n . y = r, at which it touches the disc.
/// With x = y + q v, q = g/g', g b has the components -q n . v along n and `tangential` across it.
/// b moves across n only, by -cusp/(g l q) with l² = |y|² - r²: so |b| turns where `tangential` or
/// `cusp` changes its sign, and falls at first, when both are positive.
template <typename Real>
struct NearSide {
  At<Real> at;
  Real lead;              // q, s
  Real per_y2, l2, l;     // 1/m², m², m
  Real b2;                // |g b|², m²
  Real tangential, cusp;  // m, m²; -d|b|/dt = tangential · cusp/(g l q |g b|)
};

template <typename Real>
AVO_KERNEL NearSide<Real> near_side(const Horn<Real>& horn, const At<Real>& at,
                                    const ResponseTable<typename Real::Number>& table) {
  NearSide<Real> side;
  side.at = at;
  side.lead = at.gain * at.per_rate;
  const Real r = horn.pair.r, ahead = horn.speed * side.lead, way = horn.speed * at.lag;
  const Real rise = horn.rise(way), m = way + horn.z;
  side.l2 = max(Real(0.0), horn.gap2 + rise);
  side.l = sqrt(side.l2);
  side.per_y2 = inverse(horn.closest * horn.closest + rise);
  // n . v/|v|, and -v/|v| across n
  const Real along = (r * m + side.l * horn.miss) * side.per_y2;
  const Real across = (side.l * m - r * horn.miss) * side.per_y2;
  side.tangential = side.l + ahead * across;
  const Real normal = ahead * along;
  side.b2 = normal * normal + side.tangential * side.tangential;
  const Real lag_rate =
      side.lead * (Real(1.0) - at.rate) * at.per_rate * Real(table.per_control_time);
  side.cusp = side.l2 - r * lag_rate * normal;
  return side;
}

template <typename Real>
struct TwoPoints {
  Vec<Real> near, far;
};

/// Where the circle |w| = R cuts the disc of one time, the end on the near side first.
template <typename Real>
AVO_KERNEL TwoPoints<Real> circle_points(const Horn<Real>& horn, const At<Real>& at) {
  const Vec<Real> x = horn.pair.x(at);
  const Real rise = horn.rise(horn.speed * at.time);
  const Real length = sqrt(horn.closest * horn.closest + rise), gain_R = at.gain * horn.pair.R;
  const Real per_area = inverse(gain_R * length);
  // 1 + cosine in the triangle of sides gR, |x| and r, which may be thin
  const Real r = horn.pair.r;
  const Real near = gain_R - (horn.gap2 + rise) / (length + r);  // r - |x| + gR
  const Real k = Real(0.5) * near * (r + (length - gain_R)) * per_area;
  const Real above = min(max(k, Real(0.0)), Real(2.0));
  const Real c = above - Real(1.0), s = sqrt(above * (Real(2.0) - above));
  const Vec<Real> u = (gain_R * horn.pair.R * per_area) * x;
  return {{c * u.x - s * u.y, c * u.y + s * u.x}, {c * u.x + s * u.y, c * u.y - s * u.x}};
}

/// When the search for the crossing begins and ends, and whether there is one only.
template <typename Real>
struct Passage {
  using Mask = decltype(Real() < Real());
  Real first, last;  // s
  Mask once;         // at most one crossing, between them
  Mask crosses;      // one for sure
  Mask ordinary;     // not in contact
  Real t_m;          // time of the closest approach or 0, s
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
  const Real z = horn.z, l = horn.gap, closest = horn.closest, clear = closest - pair.r;
  const Real t_m = max(-z * horn.per_speed, zero);
  const auto closing = z < zero;

  const Real lag_T = pair.R - horn.speed;
  const Real outrun = Real(0.5) * delta * horn.speed *
                      (Real(6.0) * pair.R - Real(5.0) * horn.speed) /
                      (lag_T * (Real(3.0) * pair.R - horn.speed));
  const Real T = select((lag_T > zero) & (outrun < tau), outrun, tau);
  const Real lead = T * (Real(0.5) + T * Real(table.per_control_time / 12.0));
  const Real ahead = horn.speed * lead, kappa_r = Real(kappa) * pair.r;
  auto no_turn = (horn.gap2 + horn.rise(horn.speed * (T - lead)) >= ahead * ahead) |
                 ((!closing) & (Real(2.0) * l >= kappa_r));
  if (kappa <= 2.7) {
    no_turn = no_turn | (closing & (closest >= -z) & (l >= kappa_r) &
                         (closest * l >= Real(-2.0) * z * kappa_r));
  }
  const Real r_v = pair.r * horn.speed;
  const auto no_cusp =
      ((!closing) & (l + z > Real(0.25) * pair.r)) |
      (closing & ((closest * l >= Real(0.353) * delta * r_v) |
                  (horn.gap2 > pair.r * pair.r * Real(1.0 / 16.0) + Real(0.5) * r_v * t_m)));

  const At<Real> at_m = at(table, min(t_m, tau));
  const auto in_reach =
      closing & (t_m <= tau) & (closest <= pair.R * at_m.gain) & (horn.speed <= pair.R * at_m.rate);
  return {sqrt(Real(2.0) * delta * max(clear, zero) / pair.R),
          select(in_reach, t_m, tau),
          in_reach | (no_turn & no_cusp),
          in_reach,
          clear > Real(kContact<typename Real::Number>) * pair.r,
          t_m};
}

/// See horn_walk_kernel.h.
template <typename Real>
AVO_KERNEL void walk(const Horn<Real>& horn, const ResponseTable<typename Real::Number>& table,
                     Passage<Real>& passage);

/// About where |b| = R. |g b|² is near l² at t = 0 and |v t|² at last: here the parabola with both
/// and the slope at t = 0, and g is t²/(2 δ k²), k = 1 + t/(6 δ).
template <typename Real>
AVO_KERNEL Real first_time(const Horn<Real>& horn,
                           const ResponseTable<typename Real::Number>& table) {
  const Local<Real>& pair = horn.pair;
  const Real delta = table.control_time, per_6_delta = table.per_control_time / 6.0;
  const Real per_d2 = inverse(pair.d * pair.d), back = min(horn.z, Real(0.0));
  const Real l2 = max(horn.gap2, Real(0.0)) + back * back, l = sqrt(l2);
  const Real l2_d = l2 * per_d2, v_d = horn.speed * per_d2;
  const Real slope = v_d * (horn.z + l * (l * horn.z - pair.r * horn.miss) * per_d2);
  const Real curve = v_d * horn.speed, half = pair.R * Real(0.5 * table.per_control_time);
  const Real growth = half * half * per_d2;
  const Real h = sqrt(Real(2.0) * delta * horn.gap / pair.R);
  Real t = h + h * h * per_6_delta;
  for (int i = 0; i < 2; ++i) {
    const Real k = Real(1.0) + t * per_6_delta, k2 = k * k, t2 = t * t, tk = t * k;
    const Real b2 = max(l2_d + t * (slope + t * curve), Real(1.0 / 64.0) * l2_d);
    const Real moved = b2 * k2 * k2, reach = growth * t2 * t2;
    const Real fall = Real(4.0) * b2 - (slope + Real(2.0) * t * curve) * tk;
    const Real step = Real(8.0) * (moved - reach) * b2 * tk *
                      inverse((Real(5.0) * reach + Real(3.0) * moved) * fall);
    t = t + min(max(step, Real(-0.5) * t), t);
  }
  return t;
}

/// Where |b| = R, falling, that is f = 0 where f = (|b|² - R²)/(|b|² + 3/5 R²), which is nearly
/// linear in time as (|b|/R)^{-1/2} is: Newton's iteration, then by the cubic t(f) through the last
/// two times, guarded by bisection. `tangential` is of the last time but one. Means something in
/// the lanes that are wanted.
template <typename Real>
struct Crossing {
  Real time, tangential;
};

template <typename Real>
AVO_KERNEL Crossing<Real> crossing(const Horn<Real>& horn, const Passage<Real>& passage,
                                   const ResponseTable<typename Real::Number>& table,
                                   decltype(Real() < Real()) wanted) {
  using Number = typename Real::Number;
  const Real one = Real(1.0), zero = Real(0.0), R = horn.pair.R;
  Real low = passage.first, high = passage.last;
  Real t = first_time(horn, table);
  t = select((t > low) & (t < high), t, Real(0.5) * (low + high));
  Crossing<Real> result{t, zero};
  Real last_f = one, last_pace = zero, last_t = zero, last_step = t;
  auto active = wanted, again = wanted & (!wanted);
  for (int i = 0; i < kMaxIterations; ++i) {
    const NearSide<Real> side = near_side(horn, at(table, t), table);
    const Real reach = R * side.at.gain;
    const Real R2 = reach * reach * side.per_y2, b2 = side.b2 * side.per_y2;
    const Real excess = b2 - R2, sum = b2 + Real(0.6) * R2;
    low = select(excess > zero, t, low);
    high = select(excess > zero, high, t);
    const Real fall = (side.tangential * side.l * side.per_y2) * (side.cusp * side.per_y2);
    const auto falls = fall > zero;
    const Real base = R2 * select(falls, fall, one), per = one / (sum * base);
    const Real f = excess * base * per;
    // dt/df
    const Real pace = Real(-1.0 / 3.2) * sum * sum * (side.l2 * side.per_y2 * side.lead) * sum * per;
    const Real direct = f * pace;  // Newton's
    Real step = -direct;
    const Real per_df = one / select(again, last_f - f, one);
    const Real secant = (last_t - t) * per_df, bend = (secant - pace) * per_df;
    const Real twist = ((last_pace - secant) - (secant - pace)) * per_df * per_df;
    step = select(again, step + f * f * (bend - last_f * twist), step);
    const Real newton = t + step;
    const Real error = max(abs(step), abs(direct));
    const Real least = Real(kTimeTolerance<Number>) * t;
    const auto small = falls & (error * (error + last_step) <= least * t) &
                       (error * abs(pace - last_pace) <= least * abs(pace));
    const Real next = select(falls & (small | ((newton > low) & (newton < high))), newton,
                             Real(0.5) * (low + high));
    last_f = f, last_pace = pace, last_t = t, last_step = abs(next - t), again = falls;
    t = select(active, next, t);
    result.tangential = select(active, side.tangential, result.tangential);
    active = active & (!small);
    if (!any(active)) break;
  }
  result.time = t;
  return result;
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
    Real h = select(disc_in_reach & (dot(extreme, extreme) <= R * R), dot(n, center) + radius, none);
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
  const Crossing<Real> cross =
      crossing(shape, way, table, hull.has_crossing & way.once & way.ordinary);
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
  result.settled = way.once & way.ordinary &
                   ((hull.disc_in_reach & ((cross.tangential >= Real(0.0)) | (!hull.has_crossing))) | result.free);
  return result;
}
