// SPDX-License-Identifier: Apache-2.0
// Motion of robots that can accelerate in any direction, Eqs. (7)-(9).
#ifndef AVO_ROBOTS_HOLONOMIC_KERNEL_H
#define AVO_ROBOTS_HOLONOMIC_KERNEL_H

#include "core/scalar.h"
#include "robots/motion.h"

AVO_BEGIN_KERNELS

template <typename Real>
struct Moved {
  Vec<Real> position, velocity;
  Real acceleration;  // see MotionStep
};

template <typename Real>
AVO_KERNEL Moved<Real> moved(Vec<Real> position, Vec<Real> velocity, Vec<Real> new_velocity,
                             const StepResponse& response) {
  const Vec<Real> w = new_velocity - velocity;
  Moved<Real> next;
  next.position = position + Real(response.time_step) * velocity + Real(response.gain) * w;
  next.velocity = velocity + Real(response.rate) * w;
  // a speed below the rounding of its computation counts as rest
  const auto rests = dot(next.velocity, next.velocity) < Real(0x1p-100) * dot(velocity, velocity);
  next.velocity = select(rests, constant<Real>({}), next.velocity);
  next.acceleration = norm(w) / Real(response.control_time);
  return next;
}

AVO_END_KERNELS

#endif  // once per pass
