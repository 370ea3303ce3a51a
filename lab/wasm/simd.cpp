// SPDX-License-Identifier: Apache-2.0
// Tells the host which instructions the kernels use.
#include "avo/simd.h"

/// Ends with a zero byte.
extern "C" __attribute__((export_name("simd_target"), used)) const char* avo_simd_target_name() {
  return avo::simd_target();
}
