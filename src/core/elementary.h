// SPDX-License-Identifier: Apache-2.0
// Elementary functions that use only + - × ÷: they have the same bits with every C library. The
// libraries' own functions differ from each other, and between processors, sometimes in the last
// bit.
#pragma once
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "avo/vec.h"
#include "core/sine_kernel.h"

namespace avo::elementary {

using DoubleDouble = scalar::DoubleDouble<double>;

namespace detail {

using scalar::cosine_near_zero, scalar::sine_near_zero, scalar::two_product, scalar::two_sum;

/// x - quadrant π/2, in [-π/4, π/4] up to a rounding.
struct Reduced {
  DoubleDouble rest;
  int quadrant = 0;  // 0 to 3, modulo 4
};

// For |x| <= 2^40 only the last sum rounds by more than 2^-160 x, and no such double lies nearer
// than 2^-60 to a multiple of π/2.
constexpr Reduced reduced(double x) {
  constexpr double kRound = 0x1.8p52;  // a + kRound - kRound is the whole number nearest to a
  const double quarters = (x * 0x1.45f306dc9c883p-1 + kRound) - kRound;
  if (quarters == 0.0) return {{x, 0.0}, 0};
  const DoubleDouble first = two_product(quarters, kHalfPi[0]);
  const DoubleDouble second = two_product(quarters, kHalfPi[1]);
  DoubleDouble rest = two_sum(x, -first.high);
  for (const double part : {first.low, second.high, second.low, quarters * kHalfPi[2]}) {
    rest = rest + -part;
  }
  return {rest, static_cast<int>(static_cast<std::int64_t>(quarters) & 3)};
}

constexpr double sine_of(const Reduced& x) {
  const double value = x.quadrant % 2 == 0 ? sine_near_zero(x.rest) : cosine_near_zero(x.rest);
  return x.quadrant < 2 ? value : -value;
}

// atan(k/16), by tests/golden/elementary_reference.py --tables.
inline constexpr DoubleDouble kArctangents[] = {
    {0.0, 0.0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

// atan(b/a) for 2^-60 a <= b <= a: from the nearest tan(α) = k/16, by
// tan(β - α) = (b - a tan(α)) / (a + b tan(α)), at most 1/32.
constexpr DoubleDouble arctangent(double b, double a) {
  const double sixteenths = 16.0 * (b / a) + 0.5;  // rounded to the nearest after truncation
  const auto k = static_cast<std::size_t>(sixteenths);
  const double tangent = static_cast<double>(k) / 16.0;
  const DoubleDouble z = (-two_product(tangent, a) + b) / (two_product(tangent, b) + a);
  const double square = z.high * z.high;
  double tail = 0.0;
  for (double n = 13.0; n >= 3.0; n -= 2.0) tail = -square * (1.0 / n + tail);
  return kArctangents[k] + (z + DoubleDouble{z.high * tail, 0.0});
}

}  // namespace detail

/// sin x, |x| <= 2^40; error below 0.501 of a unit in the last place.
constexpr double sin(double x) {
  if (-0x1p-27 < x && x < 0x1p-27) return x;
  return detail::sine_of(detail::reduced(x));
}

/// {cos x, sin x}, the unit vector of heading x, |x| <= 2^40; the error is that of sin.
constexpr Vec2 direction(double x) {
  if (-0x1p-27 < x && x < 0x1p-27) return {1.0, x};
  const detail::Reduced sine = detail::reduced(x);
  const detail::Reduced cosine{sine.rest, (sine.quadrant + 1) % 4};
  return {detail::sine_of(cosine), detail::sine_of(sine)};
}

/// The angle of (x, y) in [-π, π], both finite; error below 0.501 of a unit in the last place.
/// Signs of zeros have the same effect as in the C library.
inline double atan2(double y, double x) {
  double a = std::abs(x), b = std::abs(y);
  const bool steep = b > a;
  if (steep) std::swap(a, b);
  DoubleDouble angle;
  if (b < 0x1p-60 * a || a == 0.0) {
    if (!steep && !std::signbit(x)) return a == 0.0 ? y : y / x;
  } else {
    const double scale = a > 0x1p400 ? 0x1p-600 : a < 0x1p-400 ? 0x1p600 : 1.0;
    angle = detail::arctangent(scale * b, scale * a);
  }
  const DoubleDouble quarter{kHalfPi[0], kHalfPi[1]};
  if (steep) angle = quarter + -angle;
  if (std::signbit(x)) angle = DoubleDouble{2.0 * quarter.high, 2.0 * quarter.low} + -angle;
  return std::copysign(angle.high, y);
}

/// e^x - 1 for x <= 0; error below 0.9 of a unit in the last place. With x = r - n ln 2 it is
/// 2^-n e^r - 1.
inline double expm1(double x) {
  if (x == 0.0) return x;
  if (x < -40.0) return -1.0;  // past 38 it is nearer to -1 than to any other double
  constexpr double kLog2[] = {0x1.62e42fefap-1, 0x1.cf79abc9e3b3ap-40};  // products by n are exact
  const int n = static_cast<int>(0.5 - x * 0x1.71547652b82fep+0);
  const double high = x + n * kLog2[0], low = n * kLog2[1];
  const double r = high + low, rounding = (high - r) + low;
  double tail = 0.0;  // r³/3! + r⁴/4! + ...
  for (double k = 18.0; k >= 4.0; k -= 1.0) tail = r / k * (1.0 + tail);
  tail = r * r * r * ((1.0 + tail) / 6.0);
  const double grown = r + (0.5 * r * r + (tail + (rounding + rounding * r)));  // e^r - 1
  if (n == 0) return grown;
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - n) << 52);
  return n == 1 ? 0.5 * grown - 0.5 : scale * (1.0 + grown) - 1.0;
}

}  // namespace avo::elementary
