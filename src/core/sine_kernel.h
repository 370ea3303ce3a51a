// SPDX-License-Identifier: Apache-2.0
// Sine and cosine near 0, for core/elementary.h and for as many angles at once as Pack has lanes.
#ifndef AVO_CORE_SINE_KERNEL_H
#define AVO_CORE_SINE_KERNEL_H

#include <cstddef>

#include "core/double_double_kernel.h"
#include "core/sine_coefficients.h"

AVO_BEGIN_KERNELS

// z (c_0 + z (c_1 + ...))
template <typename Real, std::size_t count>
AVO_KERNEL constexpr Real polynomial(const double (&coefficients)[count], Real z) {
  Real sum(0.0);
  for (std::size_t k = count; k > 0; --k) sum = z * (Real(coefficients[k - 1]) + sum);
  return sum;
}

template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> double_double(elementary::TwoDoubles a) {
  return {Real(a.high), Real(a.low)};
}

template <typename Real>
AVO_KERNEL constexpr Real sine_near_zero(DoubleDouble<Real> r) {
  using namespace elementary;
  const DoubleDouble<Real> square = r * r;
  auto sum = double_double<Real>(kSineHead[0]) + polynomial(kSineTail, square.high);
  sum = double_double<Real>(kSineHead[1]) + square * sum;
  return (r + r * (square * sum)).high;
}

template <typename Real>
AVO_KERNEL constexpr Real cosine_near_zero(DoubleDouble<Real> r) {
  using namespace elementary;
  const DoubleDouble<Real> square = r * r;
  auto sum = double_double<Real>(kCosineHead[0]) + polynomial(kCosineTail, square.high);
  sum = double_double<Real>(kCosineHead[1]) + square * sum;
  return (double_double<Real>({1.0, 0.0}) + square * sum).high;
}

AVO_END_KERNELS

#endif  // once per pass
