// SPDX-License-Identifier: Apache-2.0
// The decision that leads to a next velocity, as many at once as Pack has lanes: Eq. (7).
#ifndef AVO_CERTIFICATE_PLAN_KERNEL_H
#define AVO_CERTIFICATE_PLAN_KERNEL_H

#include "certificate/braking_path.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// See plan_to().
template <typename Real>
struct PackPlan {
  Vec<Real> new_velocity, acceleration;
};

// Eq. (7)
template <typename Real>
AVO_KERNEL PackPlan<Real> plan_to(Vec<Real> velocity, Vec<Real> next_velocity, const StepLaw& law) {
  const Real control_time(law.control_time), rate(law.braking_time / law.control_time);
  const Vec<Real> new_velocity = velocity + (next_velocity - velocity) / rate;
  return {new_velocity, (new_velocity - velocity) / control_time};
}

AVO_END_KERNELS

#endif  // once per pass
