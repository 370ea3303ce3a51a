// SPDX-License-Identifier: Apache-2.0
// What errors and free clocks demand of a pair: docs/certificate/errors.md, "Sensing errors", and
// docs/certificate/clocks.md, "Drift".
#ifndef AVO_CERTIFICATE_MARGIN_KERNEL_H
#define AVO_CERTIFICATE_MARGIN_KERNEL_H

#include "certificate/pair_kernel.h"
#include "certificate/shape_kernel.h"

AVO_BEGIN_KERNELS

/// The demands of the sensing errors of one interval (docs/certificate/errors.md, "Sensing
/// errors").
template <typename Real>
struct PackMargin {
  Real distance;  // m, beyond the inflated contact
  Real cone;      // the largest difference of the normal from that of the true paths
};

/// distance: of the constraint; moved: how far B moves relative to A on the interval, m.
template <typename Real, int D>
AVO_RARE_KERNEL PackMargin<Real> error_margin(const BrakingPairOf<D>& pair,
                                              const PairShape<D>& shape, const StepLaw& law, Real m,
                                              Real distance, Real moved) {
  const auto& [position, velocity] = law.sensing_error;
  const Real seen = m + Real(1.0), two(2.0);
  const Real error = pair.decides ? braking_error(constant<Real>(pair.b.profile), law, seen)
                                  : Real(position) + Real(velocity) * (Real(law.time_step) * seen);
  const Real one_step(velocity * law.time_step);
  const auto beyond = distance > error;
  // if not, any value beyond it, which is not used
  const Real d = select(beyond, distance, two * error);
  const Real by_angle = two * sqrt(error / (d + error));
  const Real by_length = (with_shape(moved, shape) + error) / sqrt(d * (d - error));
  const Real cone = select(beyond, min(by_angle, by_length), two);
  return {error + cone * (moved + one_step), cone};
}

/// The margin where clocks are free. At a distance within the margin B may come as near as contact:
/// the cone alone then limits A.
template <typename Real, int D>
AVO_KERNEL PackMargin<Real> drift_margin(const BrakingPairOf<D>& pair, const StepLaw& law, Real m,
                                         Real distance, Real moved) {
  const auto& [position, velocity] = law.sensing_error;
  const BrakingProfile& b = pair.b.profile;
  const PackDrift<Real> drift =
      drift_of(Real(b.speed), Real(pair.b.increment), Real(b.decrement), law);
  const Real time = Real(law.time_step) * (m + Real(1.0));
  const Real error =
      Real(position) + Real(velocity) * time + min(drift.start + drift.per_time * time, drift.most);
  const Real zero(0.0), two(2.0);
  const auto is_clear = distance >= Real(pair.inflated) + error;
  const auto is_known = distance > zero;
  const Real turned =
      (moved + error) / sqrt(Real(pair.contact) * select(is_known, distance, Real(1.0)));
  const Real cone = select(is_known, min(turned, two), two);
  return {error, select(is_clear, zero, cone)};
}

/// The margins of a pair's intervals. is_free: both decide, each at its own times.
template <bool is_free, int D>
struct PairMargins {
  const BrakingPairOf<D>& pair;
  const PairShape<D>& shape;
  const StepLaw& law;
  const bool is_exact = !is_free && law.sensing_error == SensingError{};

  /// See error_margin().
  template <typename Real>
  AVO_KERNEL PackMargin<Real> at(Real m, Real distance, Real moved) const {
    if constexpr (is_free)
      return drift_margin(pair, law, m, distance, moved);
    else
      return is_exact ? PackMargin<Real>{Real(0.0), Real(0.0)}
                      : error_margin(pair, shape, law, m, distance, moved);
  }
};

AVO_END_KERNELS

#endif  // once per pass
