// SPDX-License-Identifier: Apache-2.0
// Which instructions the fast paths use: chosen once, forced by AVO_SIMD in the environment.
#pragma once
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "avo/error.h"

namespace avo {

/// "avx512", "avx2", "sse4", "neon" or "scalar".
inline const char* simd_target() {
  const char* forced = std::getenv("AVO_SIMD");
  return forced != nullptr && std::string_view(forced) != "auto" ? forced : "scalar";
}

/// Throws Error where AVO_SIMD names no target, or one that this machine has not.
inline void check_simd_target() {
  constexpr std::array<std::string_view, 6> kTargets{"auto", "avx512", "avx2",
                                                     "sse4", "neon",   "scalar"};
  const char* found = std::getenv("AVO_SIMD");
  if (found == nullptr || std::find(kTargets.begin(), kTargets.end(), found) != kTargets.end()) {
    return;
  }
  throw Error(std::string("AVO_SIMD: found \"") + found +
              "\", must be one of auto, avx512, avx2, sse4, neon, scalar");
}

}  // namespace avo
