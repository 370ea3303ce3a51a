// SPDX-License-Identifier: Apache-2.0
// The scalar instance of the rules for arriving, the reference that all others equal bit for bit.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

#include "certificate/kernels.h"
#include "core/scalar.h"
#include "planner/arrival.h"
#include "planner/certified.h"
#include "planner/robot_columns.h"

namespace avo::scalar {
#include "planner/arrival_kernel.h"
}  // namespace avo::scalar

namespace avo {

struct ArrivalKernels {
  void (*look_around)(std::span<const Sensing>, RobotColumns&);
  void (*keep_right)(RobotColumns&);
  void (*decide_freely)(const StepLaw&, RobotColumns&);
};

}  // namespace avo
