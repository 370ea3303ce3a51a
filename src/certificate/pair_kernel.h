// SPDX-License-Identifier: Apache-2.0
// A pair of robots that may have to brake for each other: docs/certificate.md,
// docs/certificate/clocks.md and docs/certificate/rounding.md.
#ifndef AVO_CERTIFICATE_PAIR_KERNEL_H
#define AVO_CERTIFICATE_PAIR_KERNEL_H

#include <algorithm>
#include <cmath>

#include "certificate/robot_kernel.h"
#include "core/share_kernel.h"

AVO_BEGIN_KERNELS

/// Where clocks are free, a bound of B's distance from the path on which it holds its velocity for
/// one step and then brakes. It is start + per_time t and at most `most`, m at the time t
/// (docs/certificate/clocks.md, "Drift"). In the rest of its step B may speed up, or brake.
template <typename Real>
struct PackDrift {
  Real start, per_time, most;
};

template <typename Real>
AVO_KERNEL PackDrift<Real> drift_of(Real speed, Real increment, Real decrement,
                                    const StepLaw& law) {
  const double H = law.time_step, L = law.longest_step;  // s
  const double V = L > H ? 2.0 * L - H : H;              // s: B may be faster by a V
  const Real change = max(increment, decrement);
  const Real a = change / Real(law.braking_time), weakness = change / decrement;
  const Real start = Real(0.125 * (H * H + L * L) - 0.5 * H * H) * a;
  const Real to_rest =  // a times the time to rest
      Real(H) * a + weakness * (speed + Real(law.sensing_error.velocity));
  return {start, Real(V) * a, start + Real(V) * to_rest + Real(0.5 * V * V) * a * weakness};
}

/// Additional intervals of a pair where clocks are free: B holds its velocity, and so stops later.
template <typename Real>
AVO_KERNEL Real later_intervals(Real increment, Real decrement, const StepLaw& law) {
  if (!law.has_free_clocks()) return Real(0.0);
  const double steps = std::ceil(std::max(law.longest_step / law.time_step, 0.5));
  return Real(1.0) + floor(max(increment, decrement) / decrement * Real(steps));
}

/// See BrakingPair, for a neighbor that decides.
template <typename Real, int D = 2>
struct PackPair {
  Vec<Real, D> p;
  Real distance, contact, inflated, error, share;
  PackBraking<Real, D> b;
};

/// Rounding moves a pair by at most 2^-50 of its lengths a step. While both brake these errors add
/// up, for at most so many steps. A decision reduces the sum by a share. It is four times the bound
/// in docs/certificate/rounding.md. In space: docs/space.md, "Rounding".
template <typename Real, int D = 2>
AVO_KERNEL Real rounding_margin(Real lengths, Real intervals, Real shrinks) {
  return Real(D == 2 ? 0x1p-48 : 0x1p-46) * lengths * (Real(1.0) + intervals) / shrinks;
}

/// The largest error of B's path relative to the sensed one at any time, m.
template <typename Real, int D>
AVO_KERNEL Real error_of(const PackBraking<Real, D>& b, const StepLaw& law) {
  if (law.is_exact()) return Real(0.0);
  if (!law.has_free_clocks()) return braking_error(b.profile, law, b.intervals);
  const auto& [position, velocity] = law.sensing_error;
  return Real(position) + Real(velocity * law.time_step) * b.intervals +
         drift_of(b.profile.speed, b.increment, b.profile.decrement, law).most;
}

/// kUnlike: with priorities, which matter only where some differ.
template <bool kUnlike = true, typename Real, int D>
AVO_KERNEL PackPair<Real, D> pair_of(const PackRobot<Real, D>& self,
                                     const PackRobot<Real, D>& other, const StepLaw& law) {
  const Real one(1.0);
  const Vec<Real, D> p_A = self.position;
  const PackBraking<Real, D>& a = self.braking;
  PackPair<Real, D> pair;
  pair.b = other.braking;
  pair.p = p_A - other.position;
  pair.distance = norm(pair.p);
  pair.contact = self.radius + other.radius;
  const Real a_A = self.max_acceleration, a_B = other.max_acceleration;
  pair.share = law.has_free_clocks() ? one
               : kUnlike             ? room_share(a_A, a_B, self.priority, other.priority)
                                     : a_A / (a_A + a_B);
  pair.b.intervals =
      pair.b.intervals + later_intervals(pair.b.increment, pair.b.profile.decrement, law);
  Real lengths = pair.contact + a.reach + pair.b.reach + one_norm(p_A) + one_norm(other.position);
  if constexpr (D == 3) lengths = lengths + (self.downwash + other.downwash);
  pair.inflated =
      pair.contact +
      rounding_margin<Real, D>(lengths, max(a.intervals, pair.b.intervals),
                               law.has_free_clocks() ? one : min(pair.share, one - pair.share));
  pair.error = error_of(pair.b, law);
  return pair;
}

AVO_END_KERNELS

#endif  // once per pass
