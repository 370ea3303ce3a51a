// SPDX-License-Identifier: Apache-2.0
// The horn case: its near side, and whether that crosses the circle |w| = R at most once, as it
// nearly always does. Lemmas 4 to 7 of docs/half_plane.md.
#ifndef AVO_OBSTACLES_HORN_KERNEL_H
#define AVO_OBSTACLES_HORN_KERNEL_H

#include "obstacles/half_plane_kernel.h"

AVO_BEGIN_KERNELS

// ---- horn: lemmas 4 to 7

/// A pair along its relative motion. After the distance |v| t the squared distance of the pair is
/// closest² + rise(|v| t), with terms that do not cancel. `closest` is the miss distance, or |p|
/// where p . v >= 0.
template <typename Real>
struct Horn {
  Local<Real> pair;
  Real speed, per_speed, z, miss;  // |v|, 1/|v|, p . v/|v|, m; |p x v|/|v|, m
  Real closest, gap2, gap;         // closest² - r², m², and its root

  AVO_KERNEL Real rise(Real covered) const {
    const Real w = covered + min(z, Real(0.0));
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
  // near contact the miss distance equals r up to rounding: |p|² - z² distinguishes them
  const Real back = min(horn.z, Real(0.0)), from_p = (pair.d - pair.r) * (pair.d + pair.r);
  horn.gap2 = select(abs(back) < horn.closest, from_p - back * back,
                     (horn.closest - pair.r) * (horn.closest + pair.r));
  horn.gap = sqrt(max(horn.gap2, Real(0.0)));
  return horn;
}

/// The near side at one time (lemma 4): |b| turns where `tangential` or `cusp` changes its sign,
/// and falls while both are positive.
template <typename Real>
struct NearSide {
  At<Real> at;
  Real lead;              // q, s
  Real per_y2, l2, l;     // 1/m², m², m
  Real b2;                // |g b|², m²
  Real tangential, cusp;  // m, m²
};

template <typename Real>
AVO_KERNEL NearSide<Real> near_side(const Horn<Real>& horn, const At<Real>& at,
                                    const ResponseTable& table) {
  NearSide<Real> side;
  side.at = at;
  side.lead = at.gain * at.per_rate;
  const Real r = horn.pair.r, ahead = horn.speed * side.lead, covered = horn.speed * at.lag;
  const Real rise = horn.rise(covered), mu = covered + horn.z;  // μ
  side.l2 = max(Real(0.0), horn.gap2 + rise);
  side.l = sqrt(side.l2);
  side.per_y2 = inverse(horn.closest * horn.closest + rise);
  // n . v/|v|, and -v/|v| across n
  const Real along = (r * mu + side.l * horn.miss) * side.per_y2;
  const Real across = (side.l * mu - r * horn.miss) * side.per_y2;
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

/// The points where the circle |w| = R cuts the disc of one time, the end on the near side first.
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

/// The start and the end of the search for the crossing, and whether there is only one.
template <typename Real>
struct SearchSpan {
  using Mask = decltype(Real() < Real());
  Real first, last;  // s
  Mask once;         // at most one crossing, between them
  Mask crosses;      // one crossing surely
  Mask ordinary;     // not in contact
  Real t_m;          // s, time of the closest approach, or 0
};

// Lemma 7.2, the first half: `tangential` > 0 up to the time after which the robot outruns the
// boundary (lemma 6). This time is bounded by Padé's approximation of ln, and q by t/2 + t²/(12 δ).
template <typename Real>
AVO_KERNEL auto never_tangential(const Horn<Real>& horn, const ResponseAt& horizon_end,
                                 const ResponseTable& table) {
  const Real kappa_end = (horizon_end.time - horizon_end.lag) / horizon_end.lag;
  const Real R = horn.pair.R, r = horn.pair.r, zero = Real(0.0), tau = table.end;
  const Real z = horn.z, l = horn.gap, closest = horn.closest;
  const Real spare = R - horn.speed;
  const Real outrun = Real(0.5) * Real(table.control_time) * horn.speed *
                      (Real(6.0) * R - Real(5.0) * horn.speed) /
                      (spare * (Real(3.0) * R - horn.speed));
  const Real T = select((spare > zero) & (outrun < tau), outrun, tau);
  const Real lead = T * (Real(0.5) + T * Real(table.per_control_time / 12.0));
  const Real ahead = horn.speed * lead;
  const Real kappa = min(kappa_end, lead * inverse(T - lead));
  const Real per_area = inverse(l * closest), bend = kappa * (l * z + r * closest) * per_area;
  const auto closing = z < zero;
  const auto ahead_of_all = horn.gap2 + horn.rise(horn.speed * (T - lead)) >= ahead * ahead;
  const auto receding = (!closing) & (Real(2.0) * l >= kappa * r);
  const auto passing = closing & (bend * bend < Real(4.0) * (Real(1.0) + kappa) *
                                                    (Real(1.0) + kappa * r * z * per_area));
  return ahead_of_all | receding | passing;
}

// Lemma 7.2, the second half: `cusp` > 0 always.
template <typename Real>
AVO_KERNEL auto never_cusped(const Horn<Real>& horn, Real t_m, const ResponseTable& table) {
  const Real r = horn.pair.r, r_v = r * horn.speed, l = horn.gap;
  const auto closing = horn.z < Real(0.0);
  const auto receding = (!closing) & (l + horn.z > Real(0.25) * r);
  const auto wide = horn.closest * l >= Real(0.353) * Real(table.control_time) * r_v;
  const auto late = horn.gap2 > r * r * Real(1.0 / 16.0) + Real(0.5) * r_v * t_m;
  return receding | (closing & (wide | late));
}

// Lemma 7.1: the closest approach is in reach, and stays so.
template <typename Real>
AVO_KERNEL auto closest_in_reach(const Horn<Real>& horn, Real t_m, const ResponseTable& table) {
  const Real R = horn.pair.R, tau = table.end;
  const At<Real> at_m = at(table, min(t_m, tau));
  return (horn.z < Real(0.0)) & (t_m <= tau) & (horn.closest <= R * at_m.gain) &
         (horn.speed <= R * at_m.rate);
}

template <typename Real>
AVO_KERNEL SearchSpan<Real> passage(const Horn<Real>& horn, const ResponseAt& horizon_end,
                                    const ResponseTable& table) {
  const Real r = horn.pair.r, R = horn.pair.R, zero = Real(0.0);
  const Real clear = horn.closest - r, t_m = max(-horn.z * horn.per_speed, zero);
  const auto in_reach = closest_in_reach(horn, t_m, table);
  const auto monotone = never_tangential(horn, horizon_end, table) & never_cusped(horn, t_m, table);
  return {sqrt(Real(2.0) * Real(table.control_time) * max(clear, zero) / R),
          select(in_reach, t_m, Real(table.end)),
          in_reach | monotone,
          in_reach,
          clear > Real(kContact) * r,
          t_m};
}

/// An approximate time with |b| = R. |g b|² is near l² at t = 0 and |v t|² at the end. This uses
/// the parabola with both and the slope at t = 0; g is t²/(2 δ k²), k = 1 + t/(6 δ).
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

/// A zero of f from the slopes dt/df at two times. The cubic t(f) through both has it; the result
/// is its distance beyond Newton's step from the second time. `back` is from the second time to the
/// first.
template <typename Real>
AVO_KERNEL Real beyond_newton(Real back, Real first_f, Real first_pace, Real f, Real pace) {
  const Real per_df = Real(1.0) / (first_f - f), secant = back * per_df;
  const Real bend = (secant - pace) * per_df;
  const Real twist = ((first_pace - secant) - (secant - pace)) * per_df * per_df;
  return f * f * (bend - first_f * twist);
}

/// Times between which |b| passes R once, a guess, and whether |b| falls there (1) or rises (-1).
/// The search ends when the product of the last two steps is at most `tolerance` times t². The
/// remaining error is about the square of that where the near side is smooth.
template <typename Real>
struct Bracket {
  Real low, high, guess, sense, tolerance;
};

/// The time with |b| = R, that is f = 0, where f = (|b|² - R²)/(|b|² + 3/5 R²). f is nearly linear
/// in time, as (|b|/R)^{-1/2} is. It uses Newton's iteration, then the cubic t(f) through the last
/// two times, guarded by bisection. `tangential` is of the last time but one. The result is valid
/// in the wanted lanes only.
template <typename Real>
struct HornCrossing {
  Real time, tangential;
};

template <typename Real>
AVO_KERNEL HornCrossing<Real> crossing(const Horn<Real>& horn, const Bracket<Real>& bracket,
                                       const ResponseTable& table,
                                       decltype(Real() < Real()) wanted) {
  const Real one = Real(1.0), zero = Real(0.0), R = horn.pair.R;
  Real low = bracket.low, high = bracket.high, t = bracket.guess;
  t = select((t > low) & (t < high), t, Real(0.5) * (low + high));
  HornCrossing<Real> result{t, zero};
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
    // the cubic is not used through two points nearer to each other than to f = 0: their difference
    // is rounding. Newton's step must then be as small as a first one
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
