// SPDX-License-Identifier: Apache-2.0
// One pass of core/kernel_passes.h: the group of kernels for the instruction set HWY_TARGET, or by
// core/simd128.h.
#if defined(AVO_SIMD128) || (HWY_TARGET & AVO_TARGETS)
#ifdef AVO_SIMD128
#include "core/simd128.h"  // begins the pass
#else
#include "core/lanes.h"  // begins the pass
#endif
#include AVO_KERNEL_HEADER
#ifdef AVO_KERNEL_HEADER_2
#include AVO_KERNEL_HEADER_2
#endif

AVO_BEGIN_KERNELS
constexpr AVO_KERNEL_STRUCT kKernels{AVO_KERNEL_FUNCTIONS};
AVO_END_KERNELS
#endif
