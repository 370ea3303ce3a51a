// SPDX-License-Identifier: Apache-2.0
// How a choice is executed, for as many robots at once as Pack has lanes: see execution.h.
#ifndef AVO_PLANNER_EXECUTION_KERNEL_H
#define AVO_PLANNER_EXECUTION_KERNEL_H

#include "core/response_law_kernel.h"
#include "core/scalar.h"
#include "planner/stages/execution.h"

AVO_BEGIN_KERNELS

/// See Haste.
template <typename Real>
struct PackHaste {
  Real gain, most, jerk;
};

template <typename Real>
AVO_KERNEL PackHaste<Real> haste_of(Real radius, Real max_speed, Real max_acceleration,
                                    Real distance_to_goal, const Execution& execution) {
  const Real unlimited(kUnlimited);
  const Real used = used_of(max_acceleration, max_speed, execution.law);
  const Real most = used * Real(execution.braking_time);
  if (!execution.law.is_gentle()) return {Real(1.0), most, unlimited};
  const Real time = response_time(max_speed, max_acceleration, used, execution.law);
  const Real gain = Real(execution.law.time_step) / time;
  if (!execution.remembers) return {gain, most, unlimited};
  // with a jerk limit it would oscillate about its goal there
  const Real usual = usual_response_time(max_speed, max_acceleration, execution.law);
  const auto is_there = distance_to_goal < max(radius, max_speed * usual);
  return {gain, most, select(is_there, unlimited, gain / Real(kEase) * most)};
}

/// The velocity after a step of at most `most` from v towards a target, m/s.
template <typename Real, int D>
AVO_KERNEL Vec<Real, D> approach(Vec<Real, D> velocity, Vec<Real, D> target, Real most) {
  const Vec<Real, D> change = target - velocity;
  const Real length = norm(change);
  const auto is_long = length > most;
  const Real part = most / select(is_long, length, Real(1.0));
  return select(is_long, velocity + part * change, target);
}

/// See executed().
template <typename Real, int D>
AVO_KERNEL Vec<Real, D> executed(Vec<Real, D> velocity, Vec<Real, D> last_change,
                                 Vec<Real, D> target, const PackHaste<Real>& haste) {
  const auto at_once = haste.gain >= Real(1.0);
  const Vec<Real, D> aim = select(at_once, target, velocity + haste.gain * (target - velocity));
  const Vec<Real, D> smooth =
      approach(velocity + last_change, approach(velocity, aim, haste.most), haste.jerk);
  return approach(velocity, smooth, haste.most);
}

AVO_END_KERNELS

#endif  // once per pass
