// SPDX-License-Identifier: Apache-2.0
// How far the path of a candidate gets from A's braking path: docs/certificate/left_out.md and
// docs/certificate/wheels.md.
#ifndef AVO_CERTIFICATE_DEVIATION_KERNEL_H
#define AVO_CERTIFICATE_DEVIATION_KERNEL_H

#include <cstddef>

#include "certificate/constraint_columns.h"
#include "certificate/robot_kernel.h"

AVO_BEGIN_KERNELS

/// See Deviation.
template <typename Real>
struct PackDeviation {
  struct Line {
    Real start, per_distance;
  };
  Line ahead, across, anyhow;
  PackProfile<Real> fast, slow;
  Real most_ahead, most_aside;
};

// docs/certificate/left_out.md
template <typename Real, int D>
AVO_KERNEL PackDeviation<Real> deviation_of(const PackBraking<Real, D>& a, Real stray_velocity,
                                            Real stray_distance, const StepLaw& law) {
  const Real zero(0.0), rounding(1.0 + 0x1p-30), lead(law.time_step - law.lag);
  const Real speed = a.profile.speed, u = a.profile.decrement, u_a = a.increment;
  const auto strays = stray_velocity > zero;
  const auto slow = speed < u_a, turns = (!strays) & slow, steady = !(strays | slow);
  PackDeviation<Real> result;
  result.fast = profile(speed + u_a, u);
  const PackProfile<Real> braked = profile(max(speed - u, zero), u);
  result.slow = braked;
  result.slow.speed = select(steady, braked.speed, zero);
  result.slow.full_steps = select(steady, braked.full_steps, zero);
  const Real length = stopping_length(result.fast, law), left = stopping_length(braked, law);
  const Real gained = length - select(steady, left, zero);
  result.ahead = {select(steady, rounding * lead * (u_a + u), zero),
                  select(steady, rounding, zero)};
  result.across = {select(steady, rounding * lead * u_a, zero),
                   select(steady, rounding * u_a / (speed + u_a), zero)};
  Real behind = zero;  // how far y falls behind x, where a candidate brakes harder than braking
  if (any(u_a > u)) {
    const Real least = stopping_length(profile(max(speed - u_a, zero), u), law);
    behind = max(lead * (u_a - u) + (left - least), zero);
  }
  // a change of velocity moves a braking path by no more than the change times the time
  const Real apart = Real(0.5) * stray_velocity * (u_a + max(u_a, u));
  const Real astray = apart * Real(law.time_step) * a.intervals + stray_distance;
  const Real slow_start = lead * (speed + u_a + braked.speed) + left;
  result.anyhow = {select(strays, astray, rounding * select(turns, slow_start, behind)),
                   select(turns, rounding, zero)};
  const auto over = [](const typename PackDeviation<Real>::Line& line, Real distance) {
    return line.start + line.per_distance * distance;
  };
  result.most_ahead = over(result.ahead, gained);
  result.most_aside = over(result.across, length) + over(result.anyhow, length);
  return result;
}

/// The distance of one candidate's path from A's braking path, m: the largest distance against A's
/// direction, and in any direction.
template <typename Real>
struct PackCandidateDeviation {
  Real ahead, aside;
};

// docs/certificate/left_out.md, applied to v_1 itself instead of all candidates of A
template <typename Real, int D>
AVO_KERNEL PackCandidateDeviation<Real> candidate_deviation(const PackBraking<Real, D>& a,
                                                            Vec<Real, D> next_velocity,
                                                            const StepLaw& law) {
  const Real zero(0.0), rounding(1.0 + 0x1p-30), lead(law.time_step - law.lag);
  const Real u = a.profile.decrement, speed = norm(next_velocity);
  const Real braked = max(a.profile.speed - u, zero),
             left = stopping_length(profile(braked, u), law);
  const auto moves = speed > zero;
  const Vec<Real, D> direction = (Real(1.0) / select(moves, speed, Real(1.0))) * next_velocity;
  const Real length = stopping_length(profile(speed, u), law);
  const auto steady = a.profile.speed >= a.increment;
  const Real far = lead * speed + length, margin = Real(0x1p-40) * a.reach;
  const Real ahead = dot(a.direction, direction) * far - lead * braked - left;
  Real aside = select(steady, across(a.direction, direction) * far, far);
  const auto weak = a.increment > u;
  if (any(weak)) {
    const Real along = dot(a.direction, next_velocity);
    const Real behind =
        lead * (braked - along) + left - stopping_length(profile(max(along, zero), u), law);
    aside = aside + select(weak, select(steady, max(behind, zero), lead * braked + left), zero);
  }
  return {select(steady, rounding * max(ahead, zero) + margin, zero), rounding * aside + margin};
}

/// A's braking path by interval, and the largest deviation of its candidates from it.
template <typename Real, int D>
void fill_own(const BrakingOf<D>& a, const Deviation& deviation, const StepLaw& law,
              OwnColumnsOf<D>& own) {
  for (; own.filled <= own.count; own.filled += Real::kLanes) {
    const std::size_t k = own.filled;
    const Real m = Real::numbers_from(k);
    const PackDistances<Real> braking = distances(constant<Real>(a.profile), law, m);
    const Vec<Real, D> along = constant<Real>(a.direction);
    const Vec<Real, D> start = braking.start * along, middle = braking.middle * along;
    store_vector(start, own.start, k);
    store_vector(middle, own.middle, k);
    const Real fast = distances(constant<Real>(deviation.fast), law, m).start;
    const Real gained = fast - distances(constant<Real>(deviation.slow), law, m).start;
    const auto bound = [](const Deviation::Line& line, Real distance) {
      return Real(line.start) + Real(line.per_distance) * distance;
    };
    const Real ahead = bound(deviation.ahead, gained), across = bound(deviation.across, fast);
    const Real anyhow = bound(deviation.anyhow, fast);
    ahead.store(&own.ahead[k]);
    across.store(&own.across[k]);
    anyhow.store(&own.anyhow[k]);
    (ahead + across + anyhow).store(&own.most[k]);
  }
}

AVO_END_KERNELS

#endif  // once per pass
