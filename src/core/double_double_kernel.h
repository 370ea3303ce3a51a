// SPDX-License-Identifier: Apache-2.0
// Sums of two doubles, 106 bits, for intermediate values in functions of core/elementary.h, and as
// many at once as Pack has lanes. They use only + - × ÷, without fused operations. Nothing may
// overflow; below 2^-960 products lose their second part.
#ifndef AVO_CORE_DOUBLE_DOUBLE_KERNEL_H
#define AVO_CORE_DOUBLE_DOUBLE_KERNEL_H

#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// high + low, |low| at most half of high's last bit.
template <typename Real>
struct DoubleDouble {
  Real high = Real(0.0);
  Real low = Real(0.0);
};

/// a + b exactly, for |a| >= |b| or a = 0 (Dekker 1971).
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> fast_two_sum(Real a, Real b) {
  const Real sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly (Knuth).
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> two_sum(Real a, Real b) {
  const Real sum = a + b;
  const Real part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a in two halves of 26 bits (Veltkamp), |a| < 2^990.
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> halves(Real a) {
  const Real scaled = Real(0x1.000002p27) * a;
  const Real high = scaled - (scaled - a);
  return {high, a - high};
}

/// a b exactly (Dekker).
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> two_product(Real a, Real b) {
  const Real product = a * b;
  const DoubleDouble<Real> x = halves(a), y = halves(b);
  return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> operator-(DoubleDouble<Real> a) {
  return {-a.high, -a.low};
}
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> operator+(DoubleDouble<Real> a, Real b) {
  const DoubleDouble<Real> sum = two_sum(a.high, b);
  return fast_two_sum(sum.high, sum.low + a.low);
}
/// The sum's relative error is below 2^-104 where a and b do not cancel.
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> operator+(DoubleDouble<Real> a, DoubleDouble<Real> b) {
  const DoubleDouble<Real> sum = two_sum(a.high, b.high);
  return fast_two_sum(sum.high, sum.low + (a.low + b.low));
}
/// Relative error below 2^-102.
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> operator*(DoubleDouble<Real> a, DoubleDouble<Real> b) {
  const DoubleDouble<Real> product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
/// Relative error below 2^-100.
template <typename Real>
AVO_KERNEL constexpr DoubleDouble<Real> operator/(DoubleDouble<Real> a, DoubleDouble<Real> b) {
  const Real quotient = a.high / b.high;
  const DoubleDouble<Real> rest = a + -(DoubleDouble<Real>{quotient, Real(0.0)} * b);
  return fast_two_sum(quotient, rest.high / b.high);
}

AVO_END_KERNELS

#endif  // once per pass
