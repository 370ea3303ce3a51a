// SPDX-License-Identifier: Apache-2.0
// One interval of a pair, and whether it can refuse a candidate: docs/certificate/left_out.md.
#ifndef AVO_CERTIFICATE_INTERVAL_KERNEL_H
#define AVO_CERTIFICATE_INTERVAL_KERNEL_H

#include <cstddef>

#include "certificate/constraint_columns.h"
#include "certificate/deviation_kernel.h"
#include "certificate/margin_kernel.h"
#include "certificate/other_kernel.h"
#include "certificate/pair_constraints.h"

AVO_BEGIN_KERNELS

/// One interval of a pair.
template <typename Real, int D>
struct PackInterval {
  Real m;                 // its number
  PackPoints<Real, D> x;  // of A's braking path, from p_A
  PackPoints<Real, D> q;  // from B, which may be `spread` away, to A
  Real spread, inflated;  // m; inflated: the contact with all that is known to add to it
};

template <typename Real, int D, typename Other>
AVO_KERNEL PackInterval<Real, D> interval_at(std::size_t k, const PairConstraintsOf<D>& wanted,
                                             const Other& other, const StepLaw& law,
                                             const OwnColumnsOf<D>& own) {
  const Real m = Real::numbers_from(k);
  const Vec<Real, D> p = constant<Real>(wanted.pair.p);
  const PackPoints<Real, D> x_A{load_vector<Real, D>(own.start, k),
                                load_vector<Real, D>(own.middle, k),
                                load_vector<Real, D>(own.start, k + 1)};
  const PackPoints<Real, D> x_B = other.at(k, m);
  const PackPoints<Real, D> q{p + (x_A.start - x_B.start), p + (x_A.middle - x_B.middle),
                              p + (x_A.end - x_B.end)};
  if constexpr (kDeviates<Other>) {
    const PackPoints<Real, D> from_start{p + x_A.start, p + x_A.middle, p + x_A.end};
    const Real time = (m + Real(1.0)) * Real(law.time_step);
    const PackReach<Real, D> reach = other.reach(k, q, from_start, time);
    return {m, x_A, reach.q, reach.radius, Real(wanted.inflated) + reach.radius};
  }
  return {m, x_A, q, Real(0.0), wanted.inflated};
}

/// Leaves out intervals that can refuse no candidate, whatever their n. d: A's direction in its own
/// space.
template <bool is_free, typename Real, int D, typename Mask>
AVO_KERNEL Mask without_normal(Mask close, std::size_t k, const PackInterval<Real, D>& interval,
                               const PairConstraintsOf<D>& wanted,
                               const PairMargins<is_free, D>& margins, Vec<Real, D> d,
                               const OwnColumnsOf<D>& own) {
  const auto& [m, x, q, spread, inflated] = interval;
  const PairShape<D>& shape = wanted.shape;
  const Real zero(0.0), share(wanted.pair.share), most = longest(Real::load(&own.most[k]), shape);
  const Real before = one_norm(q.middle - q.start), after = one_norm(q.end - q.middle);
  PackMargin<Real> margin = margins.at(m, Real(wanted.pair.contact), before + after);
  if (is_free) margin.cone = zero;  // a neighbor out of reach needs no cone
  const Real around = max(before, after), length = distance_to(q.middle, shape);
  const Real gap = share * (length - (inflated + around + margin.distance));
  const Real left = gap - margin.cone * most;
  close = close & !(left > most);
  if (!any(close) || has_wash(shape)) return close;
  // n points to a point so near q_1 that n is turned by less than around/w
  const Real w = length - Real(0.5) * around, turned = longest(around, shape);
  const Real E = Real::load(&own.ahead[k]), F = Real::load(&own.across[k]);
  const Real anyhow = longest(Real::load(&own.anyhow[k]), shape);
  const Vec<Real, D> own_q = in_own_space(q.middle, shape);
  const Real loss = max(-dot(own_q, d), zero) * E + across(own_q, d) * F;
  return close & !((left > zero) & ((left - anyhow) * w > loss + turned * (E + F)));
}

/// m: the largest n·(x - y) of a candidate at any of the interval's points, and what the cone adds.
template <typename Real, int D>
AVO_KERNEL Real loss_along(Vec<Real, D> n, std::size_t k, Real cone, const PairShape<D>& shape,
                           Vec<Real, D> d, const OwnColumnsOf<D>& own) {
  const Vec<Real, D> own_n = in_own_space(n, shape);
  return max(-dot(own_n, d), Real(0.0)) * Real::load(&own.ahead[k]) +
         across(own_n, d) * Real::load(&own.across[k]) +
         times_length(Real::load(&own.anyhow[k]), own_n, shape) +
         cone * longest(Real::load(&own.most[k]), shape);
}

AVO_END_KERNELS

#endif  // once per pass
