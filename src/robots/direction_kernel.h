// SPDX-License-Identifier: Apache-2.0
// elementary::direction() of as many angles at once as Pack has lanes, by the same operations in
// the same order: the same bits.
#ifndef AVO_ROBOTS_DIRECTION_KERNEL_H
#define AVO_ROBOTS_DIRECTION_KERNEL_H

#include <cstddef>

#include "core/elementary.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// As DoubleDouble, see core/double_double.h.
template <typename Real>
struct Twofold {
  Real high, low;

  static AVO_KERNEL Twofold of(DoubleDouble a) { return {Real(a.high), Real(a.low)}; }
  static AVO_KERNEL Twofold fast_sum(Real a, Real b) {
    const Real sum = a + b;
    return {sum, b - (sum - a)};
  }
  static AVO_KERNEL Twofold sum(Real a, Real b) {
    const Real sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
  }
  static AVO_KERNEL Twofold halves(Real a) {
    const Real scaled = Real(0x1.000002p27) * a, high = scaled - (scaled - a);
    return {high, a - high};
  }
  static AVO_KERNEL Twofold product(Real a, Real b) {
    const Real product = a * b;
    const Twofold x = halves(a), y = halves(b);
    return {product,
            ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
  }
  friend AVO_KERNEL Twofold operator+(Twofold a, Real b) {
    const Twofold total = sum(a.high, b);
    return fast_sum(total.high, total.low + a.low);
  }
  friend AVO_KERNEL Twofold operator+(Twofold a, Twofold b) {
    const Twofold total = sum(a.high, b.high);
    return fast_sum(total.high, total.low + (a.low + b.low));
  }
  friend AVO_KERNEL Twofold operator*(Twofold a, Twofold b) {
    const Twofold whole = product(a.high, b.high);
    return fast_sum(whole.high, whole.low + (a.high * b.low + a.low * b.high));
  }
};

/// An angle without its whole quarters of a turn: in [-π/4, π/4], but for rounding.
template <typename Real>
struct Reduced {
  Twofold<Real> rest;
  Real quadrant;  // 0 to 3, modulo 4
};

template <typename Real>
AVO_KERNEL Reduced<Real> reduced(Real x) {
  using elementary::detail::kHalfPi;
  const Real round(0x1.8p52);
  const Real quarters = (x * Real(0x1.45f306dc9c883p-1) + round) - round;
  const auto first = Twofold<Real>::product(quarters, Real(kHalfPi[0]));
  const auto second = Twofold<Real>::product(quarters, Real(kHalfPi[1]));
  Twofold<Real> rest = Twofold<Real>::sum(x, -first.high);
  rest = rest + -first.low;
  rest = rest + -second.high;
  rest = rest + -second.low;
  rest = rest + -(quarters * Real(kHalfPi[2]));
  // a quarter of it, rounded down
  const Real turns = (Real(0.25) * quarters - Real(0.375) + round) - round;
  return {rest, quarters - Real(4.0) * turns};
}

template <typename Real, std::size_t count>
AVO_KERNEL Real polynomial(const double (&coefficients)[count], Real z) {
  Real sum(0.0);
  for (std::size_t k = count; k > 0; --k) sum = z * (Real(coefficients[k - 1]) + sum);
  return sum;
}

/// The cosine and the sine of an angle near 0.
template <typename Real>
AVO_KERNEL Vec<Real> direction_near_zero(Twofold<Real> r) {
  namespace detail = elementary::detail;
  using Two = Twofold<Real>;
  const Two square = r * r;
  Two cosine = Two::of(detail::kCosineHead[0]) + polynomial(detail::kCosineTail, square.high);
  cosine = Two::of(detail::kCosineHead[1]) + square * cosine;
  Two sine = Two::of(detail::kSineHead[0]) + polynomial(detail::kSineTail, square.high);
  sine = Two::of(detail::kSineHead[1]) + square * sine;
  return {(Two::of({1.0, 0.0}) + square * cosine).high, (r + r * (square * sine)).high};
}

template <typename Real>
AVO_KERNEL Vec<Real> direction(Real x) {
  const Reduced<Real> part = reduced(x);
  const Vec<Real> near = direction_near_zero(part.rest);
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
