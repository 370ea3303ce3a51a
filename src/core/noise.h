// SPDX-License-Identifier: Apache-2.0
// Random numbers that follow from their use, and not from the previous numbers: draws need no
// memory, and several are made at once.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/hash.h"

namespace avo::inline core {

/// In [0, 1), number k of a key: a multiple of 2^-53.
constexpr double uniform_number(std::uint64_t key, std::uint64_t k) {
  return 0x1p-53 * static_cast<double>(static_cast<std::int64_t>(mixed(key, k) >> 11));
}

/// Numbers in [-most, most] from two draws each; the taken ones have the density of e^(-x²/2)
/// there.
struct GaussianDraws {
  static constexpr std::size_t kTogether = 16;
  alignas(64) std::array<double, kTogether> x;
  alignas(64) std::array<std::int64_t, kTogether> taken;  // 1 or 0
};

/// From number `first` of the key on.
void draw_gaussian(std::uint64_t key, std::uint64_t first, double most, GaussianDraws& draws);

}  // namespace avo::inline core
