// SPDX-License-Identifier: Apache-2.0
// The instruction set of the batch kernels. All instruction sets give the same bits.
#pragma once
#include "avo/export.h"

namespace avo {

/// Returns "avx512", "avx2", "sse4", "neon", "simd128" (WebAssembly) or "scalar". It is the value
/// of AVO_SIMD in the environment. It is the best set of this machine where AVO_SIMD is unset, is
/// "auto", or names a set that is not available.
AVO_API const char* simd_target();

/// Throws Error if AVO_SIMD names no instruction set, or a set that this machine or build lacks.
AVO_API void check_simd_target();

}  // namespace avo
