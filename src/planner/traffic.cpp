// SPDX-License-Identifier: Apache-2.0
// look_around() for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "planner/traffic.h"

#include <bit>
#include <cstdint>

#include "core/scalar.h"
#include "core/simd_target.h"
#include "planner/arrival.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "planner/traffic.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include "core/lanes.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
#include "planner/traffic_kernel.h"

Traffic look_around_in_lanes(const Robot& robot, const Neighbors& neighbors,
                             const TrafficLimits& limits) {
  return look_around<Pack<double>>(robot, neighbors, limits);
}
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {

namespace scalar {
#include "planner/traffic_kernel.h"
}  // namespace scalar

#ifdef AVO_HIGHWAY
HWY_EXPORT(look_around_in_lanes);
#endif

Traffic look_around(const Robot& robot, const Neighbors& neighbors, const TrafficLimits& limits) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) {
    return HWY_DYNAMIC_DISPATCH(look_around_in_lanes)(robot, neighbors, limits);
  }
#endif
  return scalar::look_around<scalar::Pack<double>>(robot, neighbors, limits);
}

}  // namespace avo
#endif
