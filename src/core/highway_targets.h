// SPDX-License-Identifier: Apache-2.0
// The instruction sets that kernels are compiled for: to be included before any header of Highway.
#pragma once

// Nobody needs what lies between the ones that have names in AVO_SIMD.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
