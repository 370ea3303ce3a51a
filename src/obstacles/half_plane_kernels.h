// SPDX-License-Identifier: Apache-2.0
// All of the half-plane's kernels, in the order in which they use each other. Included into a
// namespace that has Pack, once per instruction set.
// clang-format off
#include "obstacles/response_kernel.h"
#include "obstacles/contact_kernel.h"
#include "obstacles/half_plane_kernel.h"
#include "obstacles/horn_kernel.h"
#include "obstacles/horn_follow_kernel.h"
#include "obstacles/horn_hull_kernel.h"
#include "obstacles/half_planes_kernel.h"
#include "obstacles/shares_kernel.h"
// clang-format on
