// SPDX-License-Identifier: Apache-2.0
// Kernels by instruction set: a table of the library's own, filled by the compiler. Highway's own
// dispatch keeps the choice in a variable that all users of Highway in a program share.
#pragma once
#include <array>
#include <cstddef>

#include "core/simd_target.h"

// Highway's bits of the instruction sets for which this build has kernels. A build for any machine
// also has a plain one, which hwy/foreach_target.h visits last and which is not used.
#ifdef AVO_HIGHWAY
#include <hwy/detect_targets.h>
// g++ does not give a lambda the instruction set of its function. Where nothing is inlined, a
// lambda and what it calls then pass wide vectors differently, and the program crashes. So a build
// by g++ without optimization has only the wide vectors that the whole build has.
#if defined(__GNUC__) && !defined(__clang__) && !defined(__OPTIMIZE__)
#define AVO_WIDE_TARGETS HWY_BASELINE_TARGETS
#else
#define AVO_WIDE_TARGETS HWY_TARGETS
#endif
#define AVO_TARGETS \
  ((HWY_TARGETS & (HWY_SSE4 | HWY_NEON)) | (AVO_WIDE_TARGETS & HWY_TARGETS & (HWY_AVX3 | HWY_AVX2)))
#else
#define AVO_TARGETS 0
#endif

namespace avo::inline core {

/// One struct of function pointers for each SimdTarget; null where this build has none.
template <typename Kernels>
struct KernelTable {
  std::array<const Kernels*, kSimdTargets> by_target{};

  constexpr const Kernels*& operator[](SimdTarget target) {
    return by_target[static_cast<std::size_t>(target)];
  }
  /// The kernels of the instruction set in use.
  const Kernels* operator->() const {
    return by_target[static_cast<std::size_t>(current_simd_target())];
  }
};

}  // namespace avo::inline core
