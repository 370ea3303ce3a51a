// SPDX-License-Identifier: Apache-2.0
// The horn case: its near side, and whether that crosses the circle |w| = R once at most, as it
// nearly always does. Lemmas 4 to 7 of docs/half_plane.md.
#if defined(AVO_OBSTACLES_HORN_KERNEL_H) == defined(AVO_PASS_TOGGLE)
#ifdef AVO_OBSTACLES_HORN_KERNEL_H
#undef AVO_OBSTACLES_HORN_KERNEL_H
#else
#define AVO_OBSTACLES_HORN_KERNEL_H
#endif

#include "obstacles/half_plane_kernel.h"

AVO_BEGIN_KERNELS

/// A pair along its relative motion. After a way of |v| t the distance squared is closest² +
/// rise(|v| t), of terms that do not cancel: `closest` is the miss distance, or |p| where p . v >=
/// 0.
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
  horn.per_speed = Real(1.0) / max(horn.speed, Real(kSlowest));
  horn.z = pair.d * pair.v.x * horn.per_speed;
  horn.miss = pair.d * pair.v.y * horn.per_speed;
  horn.closest = select(horn.z < Real(0.0), horn.miss, pair.d);
  // near contact the miss distance is r to rounding: |p|² - z² tells them apart
  const Real back = min(horn.z, Real(0.0)), from_p = (pair.d - pair.r) * (pair.d + pair.r);
  horn.gap2 = select(abs(back) < horn.closest, from_p - back * back,
                     (horn.closest - pair.r) * (horn.closest + pair.r));
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
                                    const ResponseTable& table) {
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
//      (or [0, T]) if it does at T; larger bounds of T and g/g', by Padé's of ln and t/2 + t²/(12
//      δ), only make it stricter there. Exactly it reads l (|y|² + q z) > q r b, with q = |v| g/g',
//      the miss distance b and z = |v| (s - t_m), and q <= κ |v| s up to T, κ = (T - s)/s at T.
//      Receding, |y|² >= 2 b z and |v| s <= z: 2 l_0 >= κ r suffices. Else, with m = |v| t_m, it is
//      linear in q, true at q = 0, and to show at q = κ (m + z), where l (b² + z² + q z) > q r b
//      follows from l_m (b² + z² + κ (m + z) z) > κ (m + z) r b, since l >= l_m (closest point of
//      y) and m + z >= 0. That is a quadratic in z, positive at all z if its discriminant is
//      negative: κ² (l_m m - r b)² < 4 (1 + κ) l_m b (l_m b - κ r m).
//   `cusp` > 0 if l² > |v| r s' g/g', and s' g/g' is at most s/2 and 0.271 δ. Receding, l² grows
//      at least as (l_0 + z_0 |v|s...): l_0 + p . v/|v| > r/4 suffices. Else, with the miss
//      distance b, l_m² > r²/16 + r |v| t_m/2, or b l_m >= 0.353 δ r |v|: n . v/|v| is
//      (r z + l b)/(z² + b²), for which l² > c n . v/|v| at all z if b l_m >= 1.3 c.
// Else, if the closest approach is in reach, |b| <= |x|/g <= R from there on.
template <typename Real>
AVO_KERNEL Passage<Real> passage(const Horn<Real>& horn, const ResponseAt& horizon_end,
                                 const ResponseTable& table) {
  const Real kappa_end = (horizon_end.time - horizon_end.lag) / horizon_end.lag;
  const Local<Real>& pair = horn.pair;
  const Real delta = table.control_time, tau = table.end, zero = Real(0.0);
  const Real z = horn.z, l = horn.gap, closest = horn.closest, clear = closest - pair.r;
  const Real t_m = max(-z * horn.per_speed, zero);
  const auto closing = z < zero;

  const Real spare = pair.R - horn.speed;
  const Real outrun = Real(0.5) * delta * horn.speed *
                      (Real(6.0) * pair.R - Real(5.0) * horn.speed) /
                      (spare * (Real(3.0) * pair.R - horn.speed));
  const Real T = select((spare > zero) & (outrun < tau), outrun, tau);
  const Real lead = T * (Real(0.5) + T * Real(table.per_control_time / 12.0));
  const Real ahead = horn.speed * lead;
  const Real kappa = min(kappa_end, lead * inverse(T - lead)), r = pair.r;
  const Real per_area = inverse(l * closest), bend = kappa * (l * z + r * closest) * per_area;
  const auto no_turn = (horn.gap2 + horn.rise(horn.speed * (T - lead)) >= ahead * ahead) |
                       ((!closing) & (Real(2.0) * l >= kappa * r)) |
                       (closing & (bend * bend < Real(4.0) * (Real(1.0) + kappa) *
                                                     (Real(1.0) + kappa * r * z * per_area)));
  const Real r_v = r * horn.speed;
  const auto no_cusp = ((!closing) & (l + z > Real(0.25) * r)) |
                       (closing & ((closest * l >= Real(0.353) * delta * r_v) |
                                   (horn.gap2 > r * r * Real(1.0 / 16.0) + Real(0.5) * r_v * t_m)));

  const At<Real> at_m = at(table, min(t_m, tau));
  const auto in_reach =
      closing & (t_m <= tau) & (closest <= pair.R * at_m.gain) & (horn.speed <= pair.R * at_m.rate);
  return {sqrt(Real(2.0) * delta * max(clear, zero) / pair.R),
          select(in_reach, t_m, tau),
          in_reach | (no_turn & no_cusp),
          in_reach,
          clear > Real(kContact) * pair.r,
          t_m};
}

/// About where |b| = R. |g b|² is near l² at t = 0 and |v t|² at last: here the parabola with both
/// and the slope at t = 0, and g is t²/(2 δ k²), k = 1 + t/(6 δ).
template <typename Real>
AVO_KERNEL Real first_time(const Horn<Real>& horn, const ResponseTable& table) {
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

/// A zero of f by the slopes dt/df at two times: how far beyond Newton's step from the second the
/// cubic t(f) through both has it. `back` is from the second time to the first.
template <typename Real>
AVO_KERNEL Real beyond_newton(Real back, Real first_f, Real first_pace, Real f, Real pace) {
  const Real per_df = Real(1.0) / (first_f - f), secant = back * per_df;
  const Real bend = (secant - pace) * per_df;
  const Real twist = ((first_pace - secant) - (secant - pace)) * per_df * per_df;
  return f * f * (bend - first_f * twist);
}

/// Times between which |b| passes R once, a guess, and whether |b| falls there (1) or rises (-1).
/// The search ends with two steps whose product, relative, is `tolerance`; what it leaves is about
/// the square of that where the near side is smooth.
template <typename Real>
struct Bracket {
  Real low, high, guess, sense, tolerance;
};

/// Where |b| = R, that is f = 0 where f = (|b|² - R²)/(|b|² + 3/5 R²), which is nearly linear in
/// time as (|b|/R)^{-1/2} is: Newton's iteration, then by the cubic t(f) through the last two
/// times, guarded by bisection. `tangential` is of the last time but one. Means something in the
/// lanes that are wanted.
template <typename Real>
struct Crossing {
  Real time, tangential;
};

template <typename Real>
AVO_KERNEL Crossing<Real> crossing(const Horn<Real>& horn, const Bracket<Real>& bracket,
                                   const ResponseTable& table, decltype(Real() < Real()) wanted) {
  const Real one = Real(1.0), zero = Real(0.0), R = horn.pair.R;
  Real low = bracket.low, high = bracket.high, t = bracket.guess;
  t = select((t > low) & (t < high), t, Real(0.5) * (low + high));
  Crossing<Real> result{t, zero};
  Real last_f = one, last_pace = zero, last_t = zero, last_step = t;
  auto active = wanted, again = wanted & (!wanted);
  for (int i = 0; i < kMaxIterations; ++i) {
    const NearSide<Real> side = near_side(horn, at(table, t), table);
    const Real reach = R * side.at.gain;
    const Real limit = reach * reach * side.per_y2, b2 = side.b2 * side.per_y2;
    const Real excess = b2 - limit, sum = b2 + Real(0.6) * limit;
    const auto early = bracket.sense * excess > zero;
    low = select(early, t, low);
    high = select(early, high, t);
    const Real fall =
        bracket.sense * (side.tangential * side.l * side.per_y2) * (side.cusp * side.per_y2);
    const auto falls = fall > zero;
    const Real base = limit * select(falls, fall, one), per = one / (sum * base);
    const Real f = excess * base * per;
    // dt/df
    const Real pace = Real(-1.0 / 3.2) * bracket.sense * sum * sum *
                      (side.l2 * side.per_y2 * side.lead) * sum * per;
    const Real direct = f * pace;  // Newton's
    // not through two points nearer to each other than to where f = 0: their difference is
    // rounding; Newton's step then has to be as small as a first one
    const auto curved = again & (abs(last_f - f) > abs(f));
    const Real first_f = select(curved, last_f, f + one);
    const Real beyond = beyond_newton(last_t - t, first_f, last_pace, f, pace);
    const Real step = select(curved, beyond, zero) - direct;
    const Real newton = t + step;
    const Real error = max(abs(step), abs(direct));
    const Real least = bracket.tolerance * t;
    const auto small = falls & (error * (error + select(curved, last_step, t)) <= least * t) &
                       (error * abs(pace - last_pace) <= least * abs(pace));
    const Real next = select(falls & (small | ((newton > low) & (newton < high))), newton,
                             Real(0.5) * (low + high));
    last_f = f, last_pace = select(falls, pace, zero), last_t = t, last_step = abs(next - t),
    again = falls;
    t = select(active, next, t);
    result.tangential = select(active, side.tangential, result.tangential);
    active = active & (!small);
    if (!any(active)) break;
  }
  result.time = t;
  return result;
}

AVO_END_KERNELS

#endif  // once per pass
