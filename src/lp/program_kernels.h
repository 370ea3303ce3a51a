// SPDX-License-Identifier: Apache-2.0
// All of the program's kernels, in the order in which they use each other. Included into a
// namespace that has Pack, once per instruction set.
// clang-format off
#include "lp/lens_kernel.h"
#include "lp/planar_kernel.h"
#include "lp/program_kernel.h"
// clang-format on
