// SPDX-License-Identifier: Apache-2.0
// All of the certificate's kernels, in the order in which they use each other. Included into a
// namespace that has Pack, once per instruction set.
// clang-format off
#include "certificate/braking_kernel.h"
#include "certificate/plan_kernel.h"
#include "certificate/pair_kernel.h"
#include "certificate/near_kernel.h"
#include "certificate/walls_kernel.h"
#include "certificate/admission_kernel.h"
// clang-format on
