// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps, in closed form, for as many intervals at once as Pack has lanes:
// docs/certificate.md, "One step and braking".
#ifndef AVO_CERTIFICATE_BRAKING_KERNEL_H
#define AVO_CERTIFICATE_BRAKING_KERNEL_H

#include "certificate/braking_path.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// See BrakingProfile.
template <typename Real>
struct PackProfile {
  Real speed, decrement, full_steps;
};

template <typename Real>
AVO_KERNEL PackProfile<Real> constant(const BrakingProfile& braking) {
  return {Real(braking.speed), Real(braking.decrement), Real(braking.full_steps)};
}

/// Beyond this number of steps the fraction does not matter. One step of braking more or less
/// changes nothing beyond rounding, as long as all robots use the same number.
template <typename Real>
AVO_KERNEL PackProfile<Real> profile(Real speed, Real decrement) {
  const Real most(0x1p30), steps = speed / decrement;
  return {speed, decrement, select(steps < most, floor(min(steps, most)), steps)};
}

/// Distances at the start of an interval and at its middle Bézier point, m; its end is the start of
/// the next interval.
template <typename Real>
struct PackDistances {
  Real start, middle;
};

/// Distances of the interval after `steps` >= 0 steps of braking. After c steps, all of them full,
/// the speed T is left: c [Δt (u (c - 1)/2 + T) + s u]. No term is negative, nothing cancels.
template <typename Real>
AVO_KERNEL PackDistances<Real> distances(const PackProfile<Real>& braking, const StepLaw& law,
                                         Real steps) {
  const Real u = braking.decrement, full = braking.full_steps, lag(law.lag);
  const Real done = min(steps, full);
  const Real left = max(braking.speed - done * u, Real(0.0));
  const Real mean = Real(0.5) * (done - Real(1.0)) * u + left;
  const Real start = done * (Real(law.time_step) * mean + lag * u);
  const Real middle = start + lag * left;
  return {select(steps > full, middle, start), middle};
}

template <typename Real>
AVO_KERNEL Real stopping_length(const PackProfile<Real>& braking, const StepLaw& law) {
  return distances(braking, law, braking.full_steps).middle;
}

/// [e] m: the largest error of the path of a braking robot after `steps` steps. The robot is sensed
/// with the law's errors and brakes as it is seen (docs/certificate/errors.md, "Sensing errors").
template <typename Real>
AVO_KERNEL Real braking_error(const PackProfile<Real>& seen, const StepLaw& law, Real steps) {
  const auto& [position, velocity] = law.sensing_error;
  const Real to_rest = seen.full_steps + Real(1.0);  // for the sensed speed
  const PackProfile<Real> left = profile(Real(velocity), seen.decrement);
  return Real(position) + Real(velocity * law.time_step) * min(steps, to_rest) +
         distances(left, law, max(steps - to_rest, Real(0.0))).start;
}

/// The three Bézier points of an interval.
template <typename Real, int D = 2>
struct PackPoints {
  Vec<Real, D> start, middle, end;
};

template <typename Real, typename Vector>
AVO_KERNEL auto points(const BrakingProfile& profile, Vector direction, const StepLaw& law,
                       Real steps) {
  constexpr int D = sizeof(Vector) / sizeof(double);
  const PackProfile<Real> braking = constant<Real>(profile);
  const PackDistances<Real> now = distances(braking, law, steps);
  const PackDistances<Real> next = distances(braking, law, steps + Real(1.0));
  const Vec<Real, D> along = constant<Real>(direction);
  return PackPoints<Real, D>{now.start * along, now.middle * along, next.start * along};
}

AVO_END_KERNELS

#endif  // once per pass
