// SPDX-License-Identifier: Apache-2.0
// The scalar instance of the rules for arriving, the reference that all others equal bit for bit.
#pragma once
#include "planner/arrival_kernel.h"

namespace avo {

struct ArrivalKernels {
  void (*look_around)(const RobotColumns&, ArrivalColumns&);
  void (*keep_right)(const RobotColumns&, ArrivalColumns&);
  void (*decide_freely)(const StepLaw&, const RobotColumns&, ArrivalColumns&);
};

}  // namespace avo
