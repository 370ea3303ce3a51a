// SPDX-License-Identifier: Apache-2.0
// The horn case where the near side may cross the circle |w| = R more than once: walked along.
// Included after horn_kernel.h, once per instruction set.

// The time whose lag is t_m, where y comes nearest, in two steps of Newton's iteration: what lies
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

/// Times to look at the near side, as close as the passage is wide.
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

// Whether |b| turns between two times, and not too far from R to get there.
template <typename Real>
AVO_KERNEL auto turns_near(const NearSide<Real>& from, Real from_length, const NearSide<Real>& to,
                           Real to_length, Real R) {
  const auto turns =
      signs_differ(from.tangential, to.tangential) | signs_differ(from.cusp, to.cusp);
  const Real gap = min(abs(from_length - R), abs(to_length - R));
  return turns & (gap <= (to.at.time - from.at.time) * max(pace(from), pace(to)));
}

// Where more than one crossing cannot be excluded beforehand: strides along the near side. Between
// two of them |b| is monotone, or turns (`tangential` or `cusp` changes its sign) too far from R to
// get there; a lane where neither is so, or where |b| rises through R, is not `once`. Ends where
// |b| stays below R, or can only fall from there.
template <typename Real>
AVO_KERNEL void walk(const Horn<Real>& horn, const ResponseTable& table, Passage<Real>& passage) {
  const Real R = horn.pair.R, tau = table.end, zero = Real(0.0), t_m = passage.t_m;
  const Strides<Real> stride = strides(horn, t_m, table);
  auto once = (!passage.once) & passage.ordinary & (passage.first < tau);
  auto active = once;
  Real t = min(max(passage.first, t_m), tau);
  NearSide<Real> from = near_side(horn, at(table, t), table);
  Real from_length = length_of(from);
  auto inside = from_length <= R;  // |b| falls up to the closest approach
  Real low = passage.first, high = select(inside, t, tau);
  for (int i = 0; i < kMaxPieces; ++i) {
    const auto outruns = horn.speed <= R * from.at.rate;
    const auto settled = outruns & (from.at.lag >= t_m) & (from.cusp >= zero);
    const auto stays = inside & outruns & (norm(horn.pair.x(from.at)) <= R * from.at.gain);
    active = active & (!(settled | stays | (t >= tau)));
    if (!any(active)) break;
    const Real next = select(active, min(stride.next(t), tau), t);
    const NearSide<Real> to = near_side(horn, at(table, next), table);
    const Real to_length = length_of(to);
    const auto now_inside = to_length <= R;
    once =
        once &
        (!(active & (turns_near(from, from_length, to, to_length, R) | (inside & (!now_inside)))));
    const auto enters = active & now_inside & (!inside);
    low = select(enters, t, low);
    high = select(enters, next, high);
    inside = inside | enters;
    active = active & once;
    t = next;
    from = to, from_length = to_length;
  }
  once = once & (!active);
  low = select(inside, low, t);  // it may still fall through R up to the end
  passage.first = select(once, low, passage.first);
  passage.last = select(once, high, passage.last);
  passage.crosses = passage.crosses | (once & inside);
  passage.once = passage.once | once;
}
