// SPDX-License-Identifier: Apache-2.0
// The instruction set in use, for kernels and for tests that use all of them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "avo/simd.h"

namespace avo::inline core {

/// Best first; scalar kernels run one pair or robot at a time, without Highway.
enum class SimdTarget : std::uint8_t { avx512, avx2, sse4, neon, simd128, scalar };
inline constexpr std::size_t kSimdTargets = 6;

/// The instruction set in use.
SimdTarget current_simd_target();

/// Names of the instruction sets of this machine and build, best first; "scalar" is always the
/// last.
std::vector<const char*> simd_targets();

/// False, without a change, if there is none of that name. It must not be called while a kernel
/// runs.
bool use_simd_target(std::string_view name);

}  // namespace avo::inline core
