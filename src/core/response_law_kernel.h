// SPDX-License-Identifier: Apache-2.0
// How gently one robot moves by a ResponseLaw, for as many robots at once as Pack has lanes.
#ifndef AVO_CORE_RESPONSE_LAW_KERNEL_H
#define AVO_CORE_RESPONSE_LAW_KERNEL_H

#include "core/response_law.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// The least number of steps in which a robot reaches its speed; in fewer steps, decisions could
/// not follow.
inline constexpr double kFewestSteps = 5.0;

/// Part of T_e: the least time in which the acceleration rises from 0 to its used maximum.
inline constexpr double kEase = 0.8;

/// T_e as a part of T_w, the time constant with which a robot approaches its wish, without
/// comfort_jerk.
inline constexpr double kUnhurried = 0.5;

/// m/s², the part of a limit of acceleration or of braking that is used without need.
template <typename Real>
AVO_KERNEL Real used_of(Real limit, Real max_speed, const ResponseLaw& law) {
  const Real comfortable = min(limit, Real(law.comfort_acceleration));
  if (!law.is_gentle()) return comfortable;
  return min(comfortable, max_speed / Real(kFewestSteps * law.time_step));
}

/// s, without regard to comfort_jerk: below 2 Δt decisions could not follow, and beyond δ, in which
/// v' is reached, the robot could not brake.
template <typename Real>
AVO_KERNEL Real usual_response_time(Real max_speed, Real max_acceleration, const ResponseLaw& law) {
  const Real asked = Real(law.response_time) * (max_speed / max_acceleration);
  return min(max(asked, Real(2.0 * law.time_step)), Real(law.control_time));
}

/// [T_e] s, for a robot that uses this acceleration, m/s², by a gentle law: with a shorter time
/// than comfort_jerk needs it would overshoot.
template <typename Real>
AVO_KERNEL Real response_time(Real max_speed, Real max_acceleration, Real used,
                              const ResponseLaw& law) {
  return max(usual_response_time(max_speed, max_acceleration, law),
             used / Real(kEase * law.comfort_jerk));
}

AVO_END_KERNELS

#endif  // once per pass
