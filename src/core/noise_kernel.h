// SPDX-License-Identifier: Apache-2.0
// Draws side by side, in loops that compilers vectorize: no iteration has a branch, or waits for
// the one before. The numbers are the same for every instruction set.
#ifndef AVO_CORE_NOISE_KERNEL_H
#define AVO_CORE_NOISE_KERNEL_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/noise.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

/// uniform_number(), without the conversion that few instruction sets have. All of it is exact.
AVO_KERNEL double uniform_by_halves(std::uint64_t key, std::uint64_t k) {
  constexpr std::uint64_t kWhole = 0x4330000000000000u;  // of 2^52
  const std::uint64_t word = mixed(key, k);
  const double high = std::bit_cast<double>(kWhole | (word >> 32)) - 0x1p52;
  const double low = std::bit_cast<double>(kWhole | ((word >> 11) & 0x1fffffu)) - 0x1p52;
  return 0x1p-53 * (0x1p21 * high + low);
}

/// Returns whether a bound of 1/1000 decides for all draws whether they are taken: u < e^(-x²/2).
/// Undecided draws have -1. e^(-y/8) comes from its series; the next term is less than 1/8000 of
/// it.
template <typename Real>
bool draw_gaussian(std::uint64_t key, std::uint64_t first, double most, GaussianDraws& draws) {
  constexpr double kMost = 4.8, kBound = 1e-3;
  std::int64_t untold = 0;
  for (std::size_t k = 0; k < GaussianDraws::kTogether; ++k) {
    const double x = most * (2.0 * uniform_by_halves(key, first + 2 * k) - 1.0);
    const double u = uniform_by_halves(key, first + 2 * k + 1), y = 0.5 * x * x;
    const double z = 0.125 * (y < kMost ? y : kMost), zz = z * z;
    const double eighth =
        (1.0 - z) + zz * ((0.5 - z * (1.0 / 6.0)) + zz * (1.0 / 24.0 - z * (1.0 / 120.0)));
    const double fourth = eighth * eighth, half = fourth * fourth, about = half * half;
    const std::int64_t above = u > (1.0 + kBound) * about ? 1 : 0;
    const std::int64_t below = (u < (1.0 - kBound) * about ? 1 : 0) & (y <= kMost ? 1 : 0);
    const std::int64_t told = above | below;
    draws.x[k] = x, draws.taken[k] = below + told - 1;
    untold |= 1 - told;
  }
  return untold == 0;
}

AVO_END_KERNELS

#endif  // once per pass
