// SPDX-License-Identifier: Apache-2.0
// The scalar instance of the rules for arriving, the reference that all others equal bit for bit.
#pragma once
#include "planner/arrival_kernel.h"

namespace avo {

struct ArrivalKernels {
  void (*look_around)(const RobotColumns&, DecisionColumns&);
  void (*keep_right)(const RobotColumns&, DecisionColumns&);
  void (*decide_freely)(const StepLaw&, const RobotColumns&, DecisionColumns&);
};

}  // namespace avo
