// SPDX-License-Identifier: Apache-2.0
// The scalar instance of the rules for arriving, the reference that all others equal bit for bit.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

#include "certificate/kernels.h"
#include "core/scalar.h"
#include "planner/arrival.h"
#include "planner/arrival_columns.h"
#include "planner/certified.h"

namespace avo::scalar {
#include "planner/arrival_kernel.h"
}  // namespace avo::scalar

namespace avo {

struct ArrivalKernels {
  void (*look_around)(const RobotColumns&, ArrivalColumns&);
  void (*keep_right)(const RobotColumns&, ArrivalColumns&);
  void (*decide_freely)(const StepLaw&, const RobotColumns&, ArrivalColumns&);
};

}  // namespace avo
