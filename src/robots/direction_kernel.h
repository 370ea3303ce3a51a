// SPDX-License-Identifier: Apache-2.0
// elementary::direction() of as many angles at once as Pack has lanes, by the same operations in
// the same order: the same bits.
#ifndef AVO_ROBOTS_DIRECTION_KERNEL_H
#define AVO_ROBOTS_DIRECTION_KERNEL_H

#include <cstddef>

#include "core/sine_kernel.h"

AVO_BEGIN_KERNELS

/// An angle without its whole quarters of a turn: in [-π/4, π/4], but for rounding.
template <typename Real>
struct ReducedAngle {
  DoubleDouble<Real> rest;
  Real quadrant;  // 0 to 3, modulo 4
};

template <typename Real>
AVO_KERNEL ReducedAngle<Real> reduced(Real x) {
  using elementary::kHalfPi;
  const Real round(0x1.8p52);
  const Real quarters = (x * Real(0x1.45f306dc9c883p-1) + round) - round;
  const auto first = two_product(quarters, Real(kHalfPi[0]));
  const auto second = two_product(quarters, Real(kHalfPi[1]));
  DoubleDouble<Real> rest = two_sum(x, -first.high);
  rest = rest + -first.low;
  rest = rest + -second.high;
  rest = rest + -second.low;
  rest = rest + -(quarters * Real(kHalfPi[2]));
  // a quarter of it, rounded down
  const Real turns = (Real(0.25) * quarters - Real(0.375) + round) - round;
  return {rest, quarters - Real(4.0) * turns};
}

template <typename Real>
AVO_KERNEL Vec<Real> direction(Real x) {
  const ReducedAngle<Real> part = reduced(x);
  const Vec<Real> near{cosine_near_zero(part.rest), sine_near_zero(part.rest)};
  const Real q = part.quadrant;
  const auto negative_y = q > Real(1.5), negative_x = (q > Real(0.5)) & (q < Real(2.5));
  const auto odd = (negative_x & !negative_y) | (q > Real(2.5));
  Vec<Real> result{select(odd, near.y, near.x), select(odd, near.x, near.y)};
  result.x = select(negative_x, -result.x, result.x);
  result.y = select(negative_y, -result.y, result.y);
  return select(abs(x) < Real(0x1p-27), {Real(1.0), x}, result);
}

template <typename Real>
void find_directions(const double* angles, std::size_t count, double* x, double* y) {
  for (std::size_t k = 0; k < count; k += Real::kLanes) {
    const Vec<Real> found = direction(Real::load(angles + k));
    found.x.store(x + k), found.y.store(y + k);
  }
}

AVO_END_KERNELS

#endif  // once per pass
