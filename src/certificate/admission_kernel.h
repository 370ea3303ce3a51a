// SPDX-License-Identifier: Apache-2.0
// Tests a candidate against constraints, as many at once as Pack has lanes: docs/certificate.md,
// "Braking trajectories".
#ifndef AVO_CERTIFICATE_ADMISSION_KERNEL_H
#define AVO_CERTIFICATE_ADMISSION_KERNEL_H

#include <algorithm>
#include <cstddef>
#include <limits>

#include "certificate/constraints_kernel.h"

AVO_BEGIN_KERNELS

/// n·y_i + offset_i in meters, at the three points of the constraint's interval. Where a constraint
/// has a cone, the part of the cone is subtracted.
template <typename Real>
struct PackCoefficients {
  Real start, middle, end;
};

template <typename Real, int D>
AVO_KERNEL PackCoefficients<Real> coefficients(const ConstraintColumnsOf<D>& constraints,
                                               std::size_t k, const BrakingOf<D>& own,
                                               const CandidatePathOf<D>& path, const StepLaw& law,
                                               bool has_cones) {
  const Real zero(0.0), one(1.0), infinity(std::numeric_limits<double>::infinity());
  const Vec<Real, D> n = load_vector<Real, D>(constraints.normal, k);
  const Real m = Real::load(&constraints.interval[k]);
  const auto later = m > zero;  // the interval is later than the step of the decision
  // the distances of the interval's points along the braking path that follows the first step
  const PackProfile<Real> braking = constant<Real>(path.braking);
  const PackDistances<Real> before = distances(braking, law, max(m - one, zero));
  const Real end = distances(braking, law, m).start;
  const Vec<Real, D> first = constant<Real>(path.first), along = constant<Real>(path.direction);
  const Real base = dot(n, first), per_distance = dot(n, along);
  PackCoefficients<Real> result{
      base + per_distance * before.start + Real::load(&constraints.offset[0][k]),
      base + per_distance * before.middle + Real::load(&constraints.offset[1][k]),
      base + per_distance * end + Real::load(&constraints.offset[2][k])};
  if (has_cones) {
    const Real cone = Real::load(&constraints.cone[k]);
    const PackPoints<Real, D> x = points(own.profile, own.direction, law, m);
    const auto off = [&](Real distance, Vec<Real, D> from) {
      return cone * norm(first + distance * along - from);
    };
    result = {result.start - off(before.start, x.start),
              result.middle - off(before.middle, x.middle),
              result.end - off(end, x.end) - cone * Real(path.bend)};
  }
  // In the interval of the step the candidate shares y_0 and y_1 with the braking path. The other
  // case is in keeps_swing(). The bend of an arc lowers the value at the end.
  return {select(later, result.start, infinity), select(later, result.middle, infinity),
          select(later, result.end, result.end - Real(path.bend))};
}

/// Returns whether the path keeps all constraints. They are tested as far as they are asked for.
template <typename Real, int D>
bool keeps(const BrakingOf<D>& own, const CandidatePathOf<D>& path, const StepLaw& law,
           bool has_cones, Asked asked_for, ConstraintColumnsOf<D>& constraints) {
  const Real zero(0.0), infinity(std::numeric_limits<double>::infinity());
  bool kept = true;
  std::size_t k = 0;
  for (; k < constraints.count && (kept || asked_for == Asked::all); k += Real::kLanes) {
    const PackCoefficients<Real> left =
        coefficients<Real>(constraints, k, own, path, law, has_cones);
    const auto asked = Real::load(&constraints.needs[k]) < Real(static_cast<double>(path.moving));
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(constraints.count - k));
    // a value that is not a number is never admitted
    const auto good = (left.start >= zero) & (left.middle >= zero) & (left.end >= zero);
    kept = kept && !any(counted & asked & !good);
    select(asked, min(min(left.start, left.middle), left.end), infinity)
        .store(&constraints.coefficient[k]);
  }
  constraints.tested = std::min(k, constraints.count);
  return kept;
}

AVO_END_KERNELS

#endif  // once per pass
