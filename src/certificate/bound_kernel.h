// SPDX-License-Identifier: Apache-2.0
// Which neighbors can refuse nothing, by bounds of A alone: docs/certificate/left_out.md.
#ifndef AVO_CERTIFICATE_BOUND_KERNEL_H
#define AVO_CERTIFICATE_BOUND_KERNEL_H

#include <array>
#include <cmath>
#include <limits>

#include "certificate/deviation_kernel.h"
#include "certificate/pair_constraints.h"
#include "certificate/pair_kernel.h"

AVO_BEGIN_KERNELS

/// The values of A that do not depend on a neighbor: see BrakingColumns.
template <typename Real>
struct PackBound {
  Real far_distance;            // m
  std::array<Real, 3> reach;    // m, s, s²/m
  Real speed_squared;           // m²/s²
  Real clear_distance;          // m
  Real per_decrement;           // s/m
  Real most_ahead, most_aside;  // m
};

/// An upper bound of the distance of one step and stopping for a robot of speed v. It is a
/// polynomial in v: v²/2a and the loss by stopping in steps.
template <typename Real>
AVO_KERNEL std::array<Real, 3> reach_bound(Real increment, Real u, const StepLaw& law) {
  const Real h(law.time_step), half(0.5), per_u = Real(1.0) / u;
  // that a robot sensed at rest may have
  const Real top = Real(law.sensing_error.velocity) + increment;
  const Real lost(std::abs(law.lag - 0.5 * law.time_step));
  return {(h - Real(law.lag) + lost) * top + h * (half * top * top * per_u + Real(0.125) * u),
          h + h * top * per_u + lost, half * h * per_u};
}

template <typename Real, int D = 2>
AVO_KERNEL PackBound<Real> bound_of(Vec<Real, D> position, Real radius,
                                    const PackBraking<Real, D>& a,
                                    const PackDeviation<Real>& deviation, Real max_speed,
                                    const StepLaw& law) {
  const PackProfile<Real>& own = a.profile;
  const Real h(law.time_step), u = own.decrement, per_u = Real(1.0) / u;
  const Real top = Real(law.sensing_error.velocity) + a.increment;
  const std::array<Real, 3> reach = reach_bound(a.increment, u, law);
  const auto reach_at = [&reach](Real v) { return reach[0] + v * (reach[1] + v * reach[2]); };
  const Real speed = Real(kFarther) * max(max_speed, own.speed);
  const Real intervals = (Real(3.0) + later_intervals(a.increment, u, law)) + (speed + top) * per_u;
  Real error = Real(law.sensing_error.position) + Real(law.sensing_error.velocity) * h * intervals;
  if (law.has_free_clocks()) error = error + drift_of(speed, a.increment, u, law).most;
  // the part of the rounding margin that does not grow with the distance
  const Real places = one_norm(position);
  const Real lengths = radius + reach_at(own.speed);
  const Real margin = Real(0x1p-46) * (places + lengths + radius + reach_at(speed)) * intervals;
  const auto is_known = intervals <= Real(kMostIntervals);
  const Real infinity(std::numeric_limits<double>::infinity());
  return {select(is_known, lengths + error + margin, infinity),
          reach,
          speed * speed,
          select(is_known, radius + margin, infinity),
          per_u,
          deviation.most_ahead,
          deviation.most_aside};
}

/// Returns whether B has A's a_max, and is no faster than A may be. B's priority and limit of
/// braking must be A's as well.
template <typename Real, int D>
AVO_KERNEL auto is_alike(const PackBound<Real>& bound, const PackRobot<Real, D>& self,
                         const PackRobot<Real, D>& other) {
  return (dot(other.velocity, other.velocity) <= bound.speed_squared) &
         (other.max_acceleration <= self.max_acceleration) &
         (other.max_acceleration >= self.max_acceleration);
}

/// Returns whether the two are alike, and farther apart than both reach.
template <typename Real, int D>
AVO_KERNEL auto are_far(const PackBound<Real>& bound, const PackRobot<Real, D>& self,
                        const PackRobot<Real, D>& other) {
  const Real squared = dot(other.velocity, other.velocity);
  const Real reach = bound.reach[0] + bound.reach[1] * sqrt(squared) + bound.reach[2] * squared;
  const Real distance = norm(self.position - other.position);
  return is_alike(bound, self, other) &
         (distance > Real(kFarther) * (bound.far_distance + other.radius + reach));
}

/// Returns whether the two are alike, and drift towards each other too slowly for B to refuse a
/// candidate. It uses the gap of clearance_of(), with the intervals of the faster one, times the
/// part of the distance that remains after drifting. It takes no division.
template <typename Real, int D>
AVO_KERNEL auto are_clear(const PackBound<Real>& bound, const PackRobot<Real, D>& self,
                          const PackRobot<Real, D>& other, const StepLaw& law) {
  const Real zero(0.0);
  const Vec<Real, D> p = self.position - other.position;
  const Real distance = norm(p);
  const Real steps =
      Real(1.0) + bound.per_decrement * max(self.braking.profile.speed, norm(other.velocity));
  const Real drift = Real(kFarther * law.time_step) * steps * norm(self.velocity - other.velocity);
  const Real left = distance - drift;
  const Real against = min(max(zero, drift - dot(p, self.braking.direction)), left);
  const Real gap =
      Real(0.5) * (left - (bound.clear_distance + other.radius) - Real(0x1p-27) * distance);
  return is_alike(bound, self, other) & (left > zero) &
         ((gap - bound.most_aside) * left > against * bound.most_ahead);
}

AVO_END_KERNELS

#endif  // once per pass
