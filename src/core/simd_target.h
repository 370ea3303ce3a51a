// SPDX-License-Identifier: Apache-2.0
// The instruction set in use, for kernels and for tests that go through all of them.
#pragma once
#include <span>
#include <string_view>

#include "avo/simd.h"

namespace avo {

/// Those of this machine and build, best first; "scalar" is always the last.
std::span<const char* const> simd_targets();

/// False and no change if there is none of that name here. Not while a kernel runs.
bool use_simd_target(std::string_view name);

/// True where the kernels are to run one pair or robot at a time, without Highway.
bool simd_is_scalar();

}  // namespace avo
