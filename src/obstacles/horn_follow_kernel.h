// SPDX-License-Identifier: Apache-2.0
// The horn case of a close pass: its near side may come into reach, leave it around its cusps, and
// come back. Lemma 9 of docs/half_plane.md.
#ifndef AVO_OBSTACLES_HORN_FOLLOW_KERNEL_H
#define AVO_OBSTACLES_HORN_FOLLOW_KERNEL_H

#include <array>
#include <cstddef>

#include "obstacles/horn_kernel.h"

AVO_BEGIN_KERNELS

// The time with the lag t_m, where y comes nearest, by two steps of Newton's iteration. The region
// between the cusps of a close pass lies around it.
template <typename Real>
AVO_KERNEL Real cusp_time(Real t_m, const ResponseTable& table) {
  const Real per_delta = table.per_control_time;
  Real t = Real(2.0) * t_m * (Real(1.0) + t_m * per_delta * Real(1.0 / 3.0));
  for (int i = 0; i < 2; ++i) {
    const At<Real> now = at(table, min(t, Real(table.end)));
    const Real lag_rate =
        now.gain * (Real(1.0) - now.rate) * now.per_rate * now.per_rate * per_delta;
    t = max(now.time + (t_m - now.lag) / max(lag_rate, Real(1e-3)), t_m);
  }
  return t;
}

template <typename Real>
AVO_KERNEL auto signs_differ(Real a, Real b) {
  const Real zero = Real(0.0);
  return ((a < zero) & (b >= zero)) | ((a >= zero) & (b < zero));
}

/// Times at which the near side is examined, as dense as the passage is wide.
template <typename Real>
struct Strides {
  decltype(Real() < Real()) closing;
  Real t_m, t_cusp, least;  // s

  AVO_KERNEL Real next(Real t) const {
    const Real wide = select(closing, t + max(Real(0.5) * (t - t_m), least), Real(1.5) * t);
    return select((t < t_cusp) & (wide > t_cusp), t_cusp, wide);
  }
};

template <typename Real>
AVO_KERNEL Strides<Real> strides(const Horn<Real>& horn, Real t_m, const ResponseTable& table) {
  const auto closing = horn.z < Real(0.0);
  return {closing, t_m, select(closing, cusp_time(t_m, table), Real(0.0)),
          min(Real(0.125) * horn.closest * horn.per_speed, Real(0.25) * t_m)};
}

// m/s, of b
template <typename Real>
AVO_KERNEL Real length_of(const NearSide<Real>& side) {
  return sqrt(side.b2) * inverse(side.at.gain);
}
// m/s², of |b|
template <typename Real>
AVO_KERNEL Real pace(const NearSide<Real>& side) {
  return abs(side.tangential * inverse(side.at.gain * side.lead)) *
         abs(side.cusp * inverse(side.l * sqrt(side.b2)));
}

/// The near side at one time, with the values that limit what may happen up to the next time.
template <typename Real>
struct NearSideAt {
  using Mask = decltype(Real() < Real());
  Real time, length, pace;  // s; |b|, m/s; absolute value of d|b|/dt, m/s²
  Real tangential, cusp;
  Mask flat;     // `cusp` is near 0
  Mask settled;  // from here on |b| can only fall through R, once
  Mask stays;    // from here on |b| < R, if it is here
};

template <typename Real>
AVO_KERNEL NearSideAt<Real> stop(const Horn<Real>& horn, Real t, Real t_m,
                                 const ResponseTable& table) {
  const NearSide<Real> side = near_side(horn, at(table, t), table);
  const Real R = horn.pair.R;
  const auto outruns = horn.speed <= R * side.at.rate;
  return {t,
          length_of(side),
          pace(side),
          side.tangential,
          side.cusp,
          abs(side.cusp) < Real(kFlat) * side.l2,
          outruns & (side.at.lag >= t_m) & (side.cusp >= Real(0.0)),
          outruns & (norm(horn.pair.x(side.at)) <= R * side.at.gain)};
}

template <typename Real>
AVO_KERNEL void move(decltype(Real() < Real()) moves, const NearSideAt<Real>& to,
                     NearSideAt<Real>& from) {
  using S = NearSideAt<Real>;
  for (Real S::*number : {&S::time, &S::length, &S::pace, &S::tangential, &S::cusp}) {
    from.*number = select(moves, to.*number, from.*number);
  }
  for (auto S::*mask : {&S::flat, &S::settled, &S::stays}) {
    from.*mask = (moves & (to.*mask)) | ((!moves) & (from.*mask));
  }
}

// Returns whether |b| may reach R between two times at which it is on the same side of R. Either it
// turns in between, near enough to R to get there, or `cusp` may change its sign twice.
template <typename Real>
AVO_KERNEL auto may_turn_at(Real R, const NearSideAt<Real>& from, const NearSideAt<Real>& to) {
  const Real stride = to.time - from.time;
  const Real gap = min(abs(from.length - R), abs(to.length - R));
  const auto turns =
      signs_differ(from.tangential, to.tangential) | signs_differ(from.cusp, to.cusp);
  return (turns & (gap <= stride * max(from.pace, to.pace))) |
         ((from.flat | to.flat) & (stride > Real(kWide) * from.time) & (gap < Real(kWide) * R));
}

/// The crossings of the circle |w| = R: inwards, outwards, inwards.
template <typename Real>
struct Crossings {
  using Mask = decltype(Real() < Real());
  std::array<Bracket<Real>, kMostCrossings> between;
  std::array<Mask, kMostCrossings> present;
  Mask complete;  // there are no others
};

// Strides along the near side, halved where |b| may turn at R.
template <typename Real>
AVO_KERNEL Crossings<Real> follow(const Horn<Real>& horn, const SearchSpan<Real>& passage,
                                  const ResponseTable& table) {
  using Lanes = decltype(Real() < Real());
  const Real R = horn.pair.R, tau = table.end, t_m = passage.t_m;
  const Strides<Real> stride = strides(horn, t_m, table);
  const Real start = min(max(passage.first, t_m), tau);  // |b| falls up to t_m
  NearSideAt<Real> from = stop(horn, start, t_m, table);
  Real last = start;
  Lanes active = passage.ordinary & (passage.first < tau);
  Lanes inside = from.length <= R, lost = active & (!active), doubt = lost;
  const Real one = Real(1.0), tolerance = Real(kCloseTolerance);
  const Bracket<Real> fall{passage.first, start, first_time(horn, table), one, tolerance};
  const Bracket<Real> rise{start, tau, start, -one, tolerance};
  Crossings<Real> result{{fall, rise, fall}, {active & inside, lost, lost}, lost};
  for (int i = 0; i < kMaxStrides; ++i) {
    active = active & (!((inside & (from.settled | from.stays)) | (from.time >= tau)));
    if (!any(active)) break;
    const Real ahead = select(from.settled, tau, min(stride.next(from.time), tau));
    const Real next = select(doubt, Real(0.5) * (from.time + last), ahead);
    const NearSideAt<Real> to = stop(horn, next, t_m, table);
    doubt = active & (!from.settled) & may_turn_at(R, from, to);
    const auto moves = active & (!doubt), now_inside = to.length <= R;
    const auto enters = moves & now_inside & (!inside), leaves = moves & inside & (!now_inside);
    const std::array<Lanes, kMostCrossings> crosses{
        enters & (!result.present[0]), leaves & (!result.present[1]), enters & result.present[1]};
    lost = lost | (leaves & result.present[1]);
    const Real fallen = select(enters | leaves, from.length - to.length, one);
    const Real guess = from.time + (next - from.time) * ((from.length - R) / fallen);
    for (std::size_t k = 0; k < kMostCrossings; ++k) {
      Bracket<Real>& between = result.between[k];
      between.low = select(crosses[k], from.time, between.low);
      between.high = select(crosses[k], next, between.high);
      between.guess = select(crosses[k], guess, between.guess);
      result.present[k] = result.present[k] | crosses[k];
    }
    inside = (inside & (!moves)) | (moves & now_inside);
    move(moves, to, from);
    last = next;
    active = active & (!lost);
  }
  result.complete = passage.ordinary & (!(active | lost));
  return result;
}

AVO_END_KERNELS

#endif  // once per pass
