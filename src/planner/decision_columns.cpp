// SPDX-License-Identifier: Apache-2.0
// What robots do by themselves for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "planner/decision_columns.h"

#include <algorithm>

#include "core/kernel_table.h"
#include "planner/arrival_kernels.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "planner/decision_columns.cpp"
#include <hwy/foreach_target.h>
#if HWY_TARGET & AVO_TARGETS
#include "core/lanes.h"  // begins the pass
#include "planner/arrival_kernel.h"

AVO_BEGIN_KERNELS
constexpr ArrivalKernels kKernels{look_around<Pack<double>>, keep_right<Pack<double>>,
                                  decide_freely<Pack<double>>};
AVO_END_KERNELS
#endif
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace scalar {
constexpr ArrivalKernels kKernels{look_around<Pack<double>>, keep_right<Pack<double>>,
                                  decide_freely<Pack<double>>};
}  // namespace scalar

static constexpr KernelTable<ArrivalKernels> kKernels = AVO_KERNEL_TABLE(kKernels);

void look_around(const RobotColumns& robots, DecisionColumns& columns) {
  kKernels->look_around(robots, columns);
}

void keep_right(const RobotColumns& robots, DecisionColumns& columns) {
  kKernels->keep_right(robots, columns);
}

void decide_freely(const StepLaw& law, const RobotColumns& robots, DecisionColumns& columns) {
  kKernels->decide_freely(law, robots, columns);
}

void DecisionColumns::reserve(std::size_t robots) {
  state.resize(std::max(state.size(), robots));
  if (is_free.size() >= robots + kSpareNeighbors) return;  // the last to grow
  for (Column* column :
       {&range, &ahead, &push_x, &push_y, &wish_x, &wish_y, &target_x, &target_y, &violation,
        &next_x, &next_y, &unhindered_x, &unhindered_y, &new_x, &new_y, &a_x, &a_y, &is_free}) {
    column->resize(robots + kSpareNeighbors, 1.0);
  }
}

}  // namespace avo
#endif
