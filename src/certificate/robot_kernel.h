// SPDX-License-Identifier: Apache-2.0
// A robot that may have to brake, and its straight braking: docs/certificate.md, "One step and
// braking", and docs/space.md, "Any norm".
#ifndef AVO_CERTIFICATE_ROBOT_KERNEL_H
#define AVO_CERTIFICATE_ROBOT_KERNEL_H

#include "certificate/braking_kernel.h"
#include "certificate/pair.h"

AVO_BEGIN_KERNELS

/// See Braking.
template <typename Real, int D = 2>
struct PackBraking {
  PackProfile<Real> profile;
  Real increment;
  Vec<Real, D> direction;
  Real length, reach, intervals;
};

template <typename Real, int D = 2>
AVO_KERNEL PackBraking<Real, D> constant(const BrakingOf<D>& a) {
  return {.profile = constant<Real>(a.profile),
          .increment = a.increment,
          .direction = constant<Real>(a.direction),
          .length = a.length,
          .reach = a.reach,
          .intervals = a.intervals};
}

/// A robot of a pair: A, or a neighbor B that decides.
template <typename Real, int D = 2>
struct PackRobot {
  Vec<Real, D> position, velocity;
  Real radius, max_acceleration, max_braking, priority;
  PackBraking<Real, D> braking = {};
  Real vertical = Real(1.0), downwash = Real(0.0);  // read in space alone
};

template <typename Real>
AVO_KERNEL PackBraking<Real> braking_of(Vec<Real> velocity, Real max_acceleration, Real max_braking,
                                        const StepLaw& law) {
  const Real zero(0.0), one(1.0), speed = norm(velocity);
  const Real u = max_braking * Real(law.braking_time);
  const auto moves = speed > zero;
  const Vec<Real> direction = velocity / select(moves, speed, one);
  PackBraking<Real> result;
  result.profile = profile(speed, u);
  result.increment = max_acceleration * Real(law.braking_time);
  result.direction = select(moves, direction, {zero, zero});
  // the robot may be faster than it is sensed
  const PackProfile<Real> top =
      profile(speed + Real(law.sensing_error.velocity) + result.increment, u);
  result.length = stopping_length(result.profile, law);
  result.reach =
      Real(law.lag) * speed + Real(law.time_step - law.lag) * top.speed + stopping_length(top, law);
  result.intervals = Real(2.0) + top.full_steps;
  return result;
}

/// In space: a robot accelerates and brakes within an ellipsoid, a ball in its own space, in which
/// z is divided by `vertical`. It brakes straight there and so also in space (docs/space.md, "Any
/// norm").
template <typename Real>
AVO_KERNEL PackBraking<Real, 3> braking_of(Vec<Real, 3> velocity, Real max_acceleration,
                                           Real max_braking, Real vertical, const StepLaw& law) {
  const Real zero(0.0), one(1.0), speed = norm(velocity);
  const Real own_speed = norm(Vec<Real, 3>{velocity.x, velocity.y, velocity.z / vertical});
  const Real u = max_braking * Real(law.braking_time);
  const auto moves = own_speed > zero;
  const PackProfile<Real> own = profile(own_speed, u);
  const Real ratio = speed / select(moves, own_speed, one);
  PackBraking<Real, 3> result;
  result.profile = {speed, select(moves, u * ratio, u), own.full_steps};
  result.increment = max_acceleration * Real(law.braking_time);
  result.direction = select(moves, velocity / select(moves, speed, one), zero_vector<Real, 3>());
  const Real shortest = max(one, one / vertical), longest = max(one, vertical);
  // the robot may be faster than it is sensed
  const PackProfile<Real> top =
      profile(own_speed + shortest * Real(law.sensing_error.velocity) + result.increment, u);
  result.length = stopping_length(result.profile, law);
  result.reach = longest * (Real(law.lag) * own_speed + Real(law.time_step - law.lag) * top.speed +
                            stopping_length(top, law));
  result.intervals = Real(2.0) + top.full_steps;
  return result;
}

AVO_END_KERNELS

#endif  // once per pass
