// SPDX-License-Identifier: Apache-2.0
// Ways and motion in lanes, for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "sim/moving_columns.h"

#include "core/simd_target.h"
#include "planner/relevance.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/moving_columns.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include "core/lanes.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
#include "robots/holonomic_kernel.h"
#include "sim/goals_kernel.h"
#include "sim/moving_kernel.h"

void choose_ways_in_lanes(const GoalLaw& law, MovingColumns& robots) {
  choose_ways<Pack<double>>(law, robots);
}
std::uint64_t advance_in_lanes(const StepResponse& response, MovingColumns& robots) {
  return advance<Pack<double>>(response, robots);
}
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
#include "core/scalar.h"

namespace avo {
namespace scalar {
#include "robots/holonomic_kernel.h"
#include "sim/goals_kernel.h"
#include "sim/moving_kernel.h"
}  // namespace scalar

#ifdef AVO_HIGHWAY
HWY_EXPORT(choose_ways_in_lanes);
HWY_EXPORT(advance_in_lanes);
#endif

void choose_ways(const GoalLaw& law, MovingColumns& robots) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(choose_ways_in_lanes)(law, robots);
#endif
  scalar::choose_ways<scalar::Pack<double>>(law, robots);
}

std::uint64_t advance(const StepResponse& response, MovingColumns& robots) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(advance_in_lanes)(response, robots);
#endif
  return scalar::advance<scalar::Pack<double>>(response, robots);
}

}  // namespace avo
#endif
