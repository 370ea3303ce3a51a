// SPDX-License-Identifier: Apache-2.0
// How gently one robot moves by a ResponseLaw, as many robots at once as Pack has lanes.
#ifndef AVO_CORE_RESPONSE_LAW_KERNEL_H
#define AVO_CORE_RESPONSE_LAW_KERNEL_H

#include "core/response_law.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// Steps in which a robot reaches its speed at the earliest; in fewer, decisions could not follow.
inline constexpr double kFewestSteps = 5.0;

/// Of T_e: in which the acceleration goes from none to all that is used, at the earliest.
inline constexpr double kEase = 0.8;

/// Of T_w, the time constant by which a robot approaches its wish: T_e without comfort_jerk.
inline constexpr double kUnhurried = 0.5;

/// m/s², what is used of a limit of acceleration or of braking without need.
template <typename Real>
AVO_KERNEL Real used_of(Real limit, Real max_speed, const ResponseLaw& law) {
  const Real comfortable = min(limit, Real(law.comfort_acceleration));
  if (!law.is_gentle()) return comfortable;
  return min(comfortable, max_speed / Real(kFewestSteps * law.time_step));
}

/// s, without regard to comfort_jerk: below 2 Δt decisions could not follow, and beyond δ, in which
/// v' lies, the robot could not brake.
template <typename Real>
AVO_KERNEL Real usual_response_time(Real max_speed, Real max_acceleration, const ResponseLaw& law) {
  const Real asked = Real(law.response_time) * (max_speed / max_acceleration);
  return min(max(asked, Real(2.0 * law.time_step)), Real(law.control_time));
}

/// [T_e] s, of one that uses so much, m/s², by a gentle law: with less than comfort_jerk takes it
/// would overshoot.
template <typename Real>
AVO_KERNEL Real response_time(Real max_speed, Real max_acceleration, Real used,
                              const ResponseLaw& law) {
  return max(usual_response_time(max_speed, max_acceleration, law),
             used / Real(kEase * law.comfort_jerk));
}

AVO_END_KERNELS

#endif  // once per pass
