// SPDX-License-Identifier: Apache-2.0
// nearest_points() for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "lp/programs.h"

#include "core/simd_target.h"
#include "lp/planar_kernels.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lp/programs.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include "core/lanes.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
namespace planar {
// clang-format off
#include "lp/lens_kernel.h"
#include "lp/planar_kernel.h"
// clang-format on
}  // namespace planar

void solve_programs_double(ProgramBatch<double>& batch) {
  planar::solve_programs<Pack<double>>(batch);
}
void solve_programs_single(ProgramBatch<float>& batch) {
  planar::solve_programs<Pack<float>>(batch);
}
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace {

#ifdef AVO_HIGHWAY
HWY_EXPORT(solve_programs_double);
HWY_EXPORT(solve_programs_single);
#endif

}  // namespace

void nearest_points(ProgramBatch<double>& batch) noexcept {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(solve_programs_double)(batch);
#endif
  scalar::planar::solve_programs<scalar::Pack<double>>(batch);
}

void nearest_points(ProgramBatch<float>& batch) noexcept {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(solve_programs_single)(batch);
#endif
  scalar::planar::solve_programs<scalar::Pack<float>>(batch);
}

}  // namespace avo
#endif
