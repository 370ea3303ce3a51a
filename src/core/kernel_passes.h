// SPDX-License-Identifier: Apache-2.0
// Compiles a group of kernels once as the scalar instance and once for each instruction set, and
// defines avo::kKernels, the table of them all. The source file that includes this, once, defines
//   AVO_KERNEL_HEADER     the kernel header (and AVO_KERNEL_HEADER_2, where there is a second one),
//   AVO_KERNEL_STRUCT     the struct of function pointers,
//   AVO_KERNEL_FUNCTIONS  what it points to, as any pass sees it.
#include "core/kernel_table.h"
#include "core/scalar.h"
#include AVO_KERNEL_HEADER
#ifdef AVO_KERNEL_HEADER_2
#include AVO_KERNEL_HEADER_2
#endif

AVO_BEGIN_KERNELS
constexpr AVO_KERNEL_STRUCT kKernels{AVO_KERNEL_FUNCTIONS};
AVO_END_KERNELS

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernel_pass.h"
#include <hwy/foreach_target.h>
// only the instruction set of the whole build is left
#include "core/kernel_pass.h"
#endif
#ifdef AVO_SIMD128
#include "core/kernel_pass.h"
#endif

namespace avo::inline core {
static constexpr auto kKernels = [] {
  KernelTable<AVO_KERNEL_STRUCT> table;
#if AVO_TARGETS & HWY_AVX3
  table[SimdTarget::avx512] = &N_AVX3::kKernels;
#endif
#if AVO_TARGETS & HWY_AVX2
  table[SimdTarget::avx2] = &N_AVX2::kKernels;
#endif
#if AVO_TARGETS & HWY_SSE4
  table[SimdTarget::sse4] = &N_SSE4::kKernels;
#endif
#if AVO_TARGETS & HWY_NEON
  table[SimdTarget::neon] = &N_NEON::kKernels;
#endif
#ifdef AVO_SIMD128
  table[SimdTarget::simd128] = &simd128::kKernels;
#endif
  table[SimdTarget::scalar] = &scalar::kKernels;
  return table;
}();
}  // namespace avo::inline core

// headers included from here on belong to none of these passes
#undef AVO_KERNEL_HEADER
#undef AVO_KERNEL_HEADER_2
#undef AVO_KERNEL_STRUCT
#undef AVO_KERNEL_FUNCTIONS
