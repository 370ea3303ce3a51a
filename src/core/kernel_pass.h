// SPDX-License-Identifier: Apache-2.0
// One pass of core/kernel_passes.h: the group of kernels for the instruction set HWY_TARGET.
#if HWY_TARGET & AVO_TARGETS
#include "core/lanes.h"  // begins the pass
#include AVO_KERNEL_HEADER
#ifdef AVO_KERNEL_HEADER_2
#include AVO_KERNEL_HEADER_2
#endif

AVO_BEGIN_KERNELS
constexpr AVO_KERNEL_STRUCT kKernels{AVO_KERNEL_FUNCTIONS};
AVO_END_KERNELS
#endif
