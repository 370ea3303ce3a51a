// SPDX-License-Identifier: Apache-2.0
// Sums of two doubles, 106 bits, for intermediate values in functions of core/elementary.h. They
// use only + - × ÷, without fused operations. Nothing may overflow; below 2^-960 products lose
// their second part.
#pragma once

namespace avo::inline core {

/// high + low, |low| at most half of high's last bit.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;
};

/// a + b exactly, for |a| >= |b| or a = 0 (Dekker 1971).
constexpr DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly (Knuth).
constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a in two halves of 26 bits (Veltkamp), |a| < 2^990.
constexpr DoubleDouble halves(double a) {
  const double scaled = 0x1.000002p27 * a;
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// a b exactly (Dekker).
constexpr DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = halves(a), y = halves(b);
  return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

constexpr DoubleDouble operator-(DoubleDouble a) {
  return {-a.high, -a.low};
}
constexpr DoubleDouble operator+(DoubleDouble a, double b) {
  const DoubleDouble sum = two_sum(a.high, b);
  return fast_two_sum(sum.high, sum.low + a.low);
}
/// The sum's relative error is below 2^-104 where a and b do not cancel.
constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble sum = two_sum(a.high, b.high);
  return fast_two_sum(sum.high, sum.low + (a.low + b.low));
}
/// Relative error below 2^-102.
constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
/// Relative error below 2^-100.
constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double quotient = a.high / b.high;
  const DoubleDouble rest = a + -(DoubleDouble{quotient, 0.0} * b);
  return fast_two_sum(quotient, rest.high / b.high);
}

}  // namespace avo::inline core
