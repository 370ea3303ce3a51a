// SPDX-License-Identifier: Apache-2.0
// The time constant with which method avo approaches v' (PlannerOptions::response_time).
#ifndef AVO_CORE_RESPONSE_TIME_KERNEL_H
#define AVO_CORE_RESPONSE_TIME_KERNEL_H

#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// Steps in which a robot reaches its speed at the earliest; in fewer, decisions could not follow.
inline constexpr double kFewestSteps = 5.0;

/// [T_e] s, of one whose factor κ is not 0: below 2 Δt decisions could not follow, and beyond δ the
/// robot would be slower than Eq. (7).
template <typename Real>
AVO_KERNEL Real response_time(Real max_speed, Real max_acceleration, double factor,
                              double time_step, double control_time) {
  const Real least(2.0 * time_step), most(control_time);
  return min(max(Real(factor) * (max_speed / max_acceleration), least), most);
}

/// Of T_e: in which the acceleration goes from none to all that is used, at the earliest.
inline constexpr double kEase = 0.8;

/// [T_e] s, of one that uses so much acceleration (m/s²), which changes by `jerk` m/s³ at most: with
/// less it would overshoot.
template <typename Real>
AVO_KERNEL Real eased(Real response_time, Real used, double jerk) {
  return max(response_time, used / Real(kEase * jerk));
}

AVO_END_KERNELS

#endif  // once per pass
