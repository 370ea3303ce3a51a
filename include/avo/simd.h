// SPDX-License-Identifier: Apache-2.0
// Which instructions the batch kernels use. Whatever they are, the results have the same bits.
#pragma once
#include "avo/export.h"

namespace avo {

/// "avx512", "avx2", "sse4", "neon", "simd128" (WebAssembly) or "scalar": what AVO_SIMD asks for in
/// the environment, or the best of this machine where it asks for nothing, for "auto", or for what
/// cannot be had.
AVO_API const char* simd_target();

/// Throws Error if AVO_SIMD names no instruction set, or one that this machine or build lacks.
AVO_API void check_simd_target();

}  // namespace avo
