// SPDX-License-Identifier: Apache-2.0
// What robots do by themselves for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "planner/robot_columns.h"

#include "core/simd_target.h"
#include "planner/arrival_kernels.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "planner/robot_columns.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include "core/lanes.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
#include "certificate/plan_kernel.h"
#include "planner/arrival_kernel.h"

void look_around_in_lanes(std::span<const Sensing> robots, RobotColumns& columns) {
  look_around<Pack<double>>(robots, columns);
}
void keep_right_in_lanes(RobotColumns& columns) {
  keep_right<Pack<double>>(columns);
}
void decide_freely_in_lanes(const StepLaw& law, RobotColumns& columns) {
  decide_freely<Pack<double>>(law, columns);
}
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {

#ifdef AVO_HIGHWAY
HWY_EXPORT(look_around_in_lanes);
HWY_EXPORT(keep_right_in_lanes);
HWY_EXPORT(decide_freely_in_lanes);
#endif

void look_around(std::span<const Sensing> robots, RobotColumns& columns) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(look_around_in_lanes)(robots, columns);
#endif
  scalar::look_around<scalar::Pack<double>>(robots, columns);
}

void keep_right(RobotColumns& columns) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(keep_right_in_lanes)(columns);
#endif
  scalar::keep_right<scalar::Pack<double>>(columns);
}

void decide_freely(const StepLaw& law, RobotColumns& columns) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(decide_freely_in_lanes)(law, columns);
#endif
  scalar::decide_freely<scalar::Pack<double>>(law, columns);
}

void RobotColumns::reserve(std::size_t robots) {
  if (v_x.size() >= robots + kSpareNeighbors) return;
  for (Column* column : {&v_x,
                         &v_y,
                         &preferred_x,
                         &preferred_y,
                         &distance,
                         &radius,
                         &max_acceleration,
                         &max_speed,
                         &range,
                         &ahead,
                         &push_x,
                         &push_y,
                         &wish_x,
                         &wish_y,
                         &target_x,
                         &target_y,
                         &next_x,
                         &next_y,
                         &unhindered_x,
                         &unhindered_y,
                         &new_x,
                         &new_y,
                         &a_x,
                         &a_y,
                         &is_free}) {
    column->resize(robots + kSpareNeighbors, 1.0);
  }
}

}  // namespace avo
#endif
