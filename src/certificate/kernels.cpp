// SPDX-License-Identifier: Apache-2.0
// The certificate's kernels for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "certificate/kernels.h"

#include "core/simd_target.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certificate/kernels.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include "core/lanes.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
#include "certificate/certificate_kernels.h"

void find_near_lanes(std::span<const Sensing> robots, Whom whom, const StepLaw& law,
                     NearPairs& near) {
  find_near<Pack<double>>(robots, whom, law, near);
}
void fill_own_lanes(const Braking& a, const Deviation& deviation, const StepLaw& law,
                    OwnColumns& own) {
  fill_own<Pack<double>>(a, deviation, law, own);
}
double append_walls_lanes(const PairWalls& of, const StepLaw& law, const OwnColumns& own,
                          WallColumns& walls) {
  return append_walls<Pack<double>>(of, law, own, walls);
}
bool keeps_lanes(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
                 WallColumns& walls) {
  return keeps<Pack<double>>(own, path, law, has_cones, walls);
}
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {

#ifdef AVO_HIGHWAY
HWY_EXPORT(find_near_lanes);
HWY_EXPORT(fill_own_lanes);
HWY_EXPORT(append_walls_lanes);
HWY_EXPORT(keeps_lanes);
#endif

void find_near(std::span<const Sensing> robots, Whom whom, const StepLaw& law, NearPairs& near) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(find_near_lanes)(robots, whom, law, near);
#endif
  scalar::find_near<scalar::Pack<double>>(robots, whom, law, near);
}

void fill_own(const Braking& a, const Deviation& deviation, const StepLaw& law, OwnColumns& own) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(fill_own_lanes)(a, deviation, law, own);
#endif
  scalar::fill_own<scalar::Pack<double>>(a, deviation, law, own);
}

double append_walls(const PairWalls& of, const StepLaw& law, const OwnColumns& own,
                    WallColumns& walls) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(append_walls_lanes)(of, law, own, walls);
#endif
  return scalar::append_walls<scalar::Pack<double>>(of, law, own, walls);
}

bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           WallColumns& walls) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) {
    return HWY_DYNAMIC_DISPATCH(keeps_lanes)(own, path, law, has_cones, walls);
  }
#endif
  return scalar::keeps<scalar::Pack<double>>(own, path, law, has_cones, walls);
}

}  // namespace avo
#endif
