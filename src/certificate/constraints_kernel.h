// SPDX-License-Identifier: Apache-2.0
// The constraints of one pair, for as many intervals at once as Pack has lanes:
// docs/certificate.md, "Braking trajectories".
#ifndef AVO_CERTIFICATE_CONSTRAINTS_KERNEL_H
#define AVO_CERTIFICATE_CONSTRAINTS_KERNEL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "certificate/constraint_columns.h"
#include "certificate/interval_kernel.h"
#include "certificate/pair_constraints.h"

AVO_BEGIN_KERNELS

/// The constraints of a pair.
template <typename Real, int D>
struct PackConstraints {
  Vec<Real, D> normal;
  Real cone, bound;
  std::array<Real, 3> offset;
};

template <bool is_free, typename Real, int D>
AVO_KERNEL PackConstraints<Real, D> constraints_of(const PairConstraintsOf<D>& wanted,
                                                   const PackPoints<Real, D>& own,
                                                   const PackPoints<Real, D>& q, Vec<Real, D> n,
                                                   Real distance, const PackMargin<Real>& margin) {
  const Real share(wanted.pair.share), held(wanted.pair.share * wanted.held);
  const auto offset = [&](Vec<Real, D> of_q, Vec<Real, D> of_x) {
    if constexpr (is_free) {  // a cone does not use the gap
      const Real gap = dot(n, of_q) - margin.distance - held;
      const Real rounding(wanted.pair.contact - wanted.pair.inflated);
      return select(margin.cone > Real(0.0), rounding, gap) - dot(n, of_x);
    } else {
      return share * (dot(n, of_q) - margin.distance) - dot(n, of_x);  // see hold()
    }
  };
  const Real loss = share * (margin.distance - distance);
  return {n,
          margin.cone,
          is_free ? loss + held : loss,
          {offset(q.start, own.start), offset(q.middle, own.middle), offset(q.end, own.end)}};
}

/// Stores the constraints of all lanes. Lanes that are not kept are marked as no constraints, so
/// that no gap has to be closed.
template <typename Real, int D, typename Mask>
AVO_KERNEL void push(const PackConstraints<Real, D>& fresh, Real m, Mask kept,
                     const PairConstraintsOf<D>& wanted, ConstraintColumnsOf<D>& constraints) {
  const std::size_t w = constraints.count;
  store_vector(fresh.normal, constraints.normal, w);
  fresh.cone.store(&constraints.cone[w]);
  fresh.bound.store(&constraints.bound[w]);
  for (std::size_t i = 0; i < 3; ++i) fresh.offset[i].store(&constraints.offset[i][w]);
  m.store(&constraints.interval[w]);
  const Real needs = select(m < Real(wanted.moving), Real(-1.0), m);
  select(kept, needs, Real(kNoConstraint)).store(&constraints.needs[w]);
  for (std::size_t k = 0; k < Real::kLanes; ++k) constraints.neighbor[w + k] = wanted.neighbor;
  constraints.count += Real::kLanes;
}

/// Appends the constraints that can refuse a candidate. Returns the least distance of the intervals
/// that are computed in full; in the others it is beyond contact.
template <typename Real, bool is_free, int D, typename Other>
double append(const PairConstraintsOf<D>& wanted, const Other& other, const StepLaw& law,
              const OwnColumnsOf<D>& own, ConstraintColumnsOf<D>& constraints) {
  const BrakingPairOf<D>& pair = wanted.pair;
  const PairShape<D>& shape = wanted.shape;
  const Real zero(0.0), share(pair.share);
  const Vec<Real, D> d = constant<Real>(own_direction(pair.a.direction, shape));
  const PairMargins<is_free, D> margins{pair, shape, law};
  Real nearest(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < wanted.intervals; k += Real::kLanes) {
    const PackInterval<Real, D> interval = interval_at<Real>(k, wanted, other, law, own);
    const auto& [m, x_A, q, spread, inflated] = interval;
    // intervals that are computed in full, each by itself, so that the number of lanes has no
    // influence
    auto close = m < Real(static_cast<double>(wanted.intervals));
    close = without_normal(close, k, interval, wanted, margins, d, own);
    if (!any(close)) continue;
    const Vec<Real, D> n = normal_of(q, shape);
    const Real distance = min(min(dot(n, q.start), dot(n, q.middle)), dot(n, q.end));
    Real wash = zero, apart = distance;  // apart: from the shape
    if constexpr (D == 3) wash = support(n, shape), apart = distance - wash;
    const auto holds = m < Real(wanted.moving);  // the invariant covers the interval
    constexpr bool kSpreads = kDeviates<Other> || D == 3;
    const Real beside = D == 3 ? spread + wash : spread;
    const Real left = kSpreads ? distance - beside : distance;
    nearest = select(close & holds & (left < nearest), left, nearest);
    const Real moved = margins.is_exact  // only errors need it
                           ? zero
                           : norm(q.middle - q.start) + norm(q.end - q.middle);
    PackMargin<Real> margin = margins.at(m, apart, moved);
    const Real needed = D == 3 ? inflated + wash : inflated;
    const Real loss = loss_along(n, k, margin.cone, shape, d, own);
    const auto kept = close & !(share * (distance - needed - margin.distance) > loss);
    // the invariant does not cover intervals in which A rests: the margin is 0 there
    margin = {select(holds, margin.distance, zero), select(holds, margin.cone, zero)};
    if constexpr (kSpreads) margin.distance = margin.distance + beside;
    if (any(kept))
      push(constraints_of<is_free>(wanted, x_A, q, n, distance, margin), m, kept, wanted,
           constraints);
  }
  alignas(64) std::array<double, Real::kLanes> lanes;
  nearest.store(lanes.data());
  return *std::min_element(lanes.begin(), lanes.end());
}

/// Subtracts the held distance from the pair's constraints, the last ones from `first` on.
/// Constraints of free clocks already contain it.
template <typename Real, int D>
void hold(const PairConstraintsOf<D>& wanted, std::size_t first,
          ConstraintColumnsOf<D>& constraints) {
  const Real held(wanted.pair.share * wanted.held);
  for (std::size_t k = first; k < constraints.count; k += Real::kLanes) {
    (Real::load(&constraints.bound[k]) + held).store(&constraints.bound[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      double* offset = &constraints.offset[i][k];
      (Real::load(offset) - held).store(offset);
    }
  }
}

template <typename Real>
double append_constraints(const PairConstraints& wanted, const StepLaw& law, const OwnColumns& own,
                          ConstraintColumns& constraints) {
  if (wanted.trajectory != nullptr)
    return append<Real, false>(
        wanted, FollowingOther<Real>{wanted.other, *wanted.trajectory, law.lag / law.time_step},
        law, own, constraints);
  const MovingOther<Real> mover{wanted.other, law};
  if (!wanted.pair.decides && wanted.other.max_deviation > 0.0)
    return append<Real, false>(wanted, DeviatingOther<Real>{mover}, law, own, constraints);
  if (!wanted.pair.decides) return append<Real, false>(wanted, mover, law, own, constraints);
  if (wanted.is_free)
    return append<Real, true>(wanted, HoldingOther<Real>{wanted.pair, law}, law, own, constraints);
  return append<Real, false>(wanted, BrakingOther<Real>{wanted.pair, law}, law, own, constraints);
}

/// The same in space, of a neighbor that decides at the same times.
template <typename Real>
double append_in_space(const PairConstraintsOf<3>& wanted, const StepLaw& law,
                       const OwnColumnsOf<3>& own, ConstraintColumnsOf<3>& constraints) {
  return append<Real, false>(wanted, BrakingOther<Real, 3>{wanted.pair, law}, law, own,
                             constraints);
}

AVO_END_KERNELS

#endif  // once per pass
