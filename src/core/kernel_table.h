// SPDX-License-Identifier: Apache-2.0
// Kernels by instruction set: a table of our own, filled by the compiler. Highway's own dispatch
// keeps the choice in a variable that all users of Highway in a program share.
#pragma once
#include <array>
#include <cstddef>

#include "core/simd_target.h"
#ifdef AVO_HIGHWAY
#include <hwy/detect_targets.h>
#endif

namespace avo {

/// One struct of function pointers for each SimdTarget; null where this build has none.
template <typename Kernels>
struct KernelTable {
  std::array<const Kernels*, kSimdTargets> by_target;

  /// Those of the instruction set in use.
  const Kernels* operator->() const {
    return by_target[static_cast<std::size_t>(current_simd_target())];
  }
};

}  // namespace avo

// AVO_TARGETS: Highway's bits of the instruction sets that this build has kernels for. A build for
// any machine has a plain one besides, which hwy/foreach_target.h visits last and nobody uses.
// AVO_KERNEL_TABLE(kernels): the table of the constants of this name, of each instruction set's
// namespace and of avo::scalar.
#ifdef AVO_HIGHWAY
#define AVO_TARGETS (HWY_TARGETS & (HWY_AVX3 | HWY_AVX2 | HWY_SSE4 | HWY_NEON))
#else
#define AVO_TARGETS 0
#endif
#if defined(AVO_HIGHWAY) && (HWY_TARGETS & HWY_AVX3)
#define AVO_AVX512_KERNELS(kernels) &N_AVX3::kernels
#else
#define AVO_AVX512_KERNELS(kernels) nullptr
#endif
#if defined(AVO_HIGHWAY) && (HWY_TARGETS & HWY_AVX2)
#define AVO_AVX2_KERNELS(kernels) &N_AVX2::kernels
#else
#define AVO_AVX2_KERNELS(kernels) nullptr
#endif
#if defined(AVO_HIGHWAY) && (HWY_TARGETS & HWY_SSE4)
#define AVO_SSE4_KERNELS(kernels) &N_SSE4::kernels
#else
#define AVO_SSE4_KERNELS(kernels) nullptr
#endif
#if defined(AVO_HIGHWAY) && (HWY_TARGETS & HWY_NEON)
#define AVO_NEON_KERNELS(kernels) &N_NEON::kernels
#else
#define AVO_NEON_KERNELS(kernels) nullptr
#endif
#define AVO_KERNEL_TABLE(kernels)                                                        \
  {                                                                                      \
    {                                                                                    \
      AVO_AVX512_KERNELS(kernels), AVO_AVX2_KERNELS(kernels), AVO_SSE4_KERNELS(kernels), \
          AVO_NEON_KERNELS(kernels), &scalar::kernels                                    \
    }                                                                                    \
  }
