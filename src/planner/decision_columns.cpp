// SPDX-License-Identifier: Apache-2.0
// What robots compute by themselves, for every instruction set; the best one is chosen at run time.
#include "planner/decision_columns.h"

#include <algorithm>

namespace avo::inline planner {
struct ArrivalKernels {
  void (*look_around)(const RobotColumns&, DecisionColumns&);
  void (*keep_right)(const RobotColumns&, DecisionColumns&);
  void (*decide_freely)(const StepLaw&, const Execution&, const RobotColumns&, DecisionColumns&);
};
}  // namespace avo::inline planner

#define AVO_KERNEL_HEADER "planner/arrival_kernel.h"
#define AVO_KERNEL_STRUCT ArrivalKernels
#define AVO_KERNEL_FUNCTIONS \
  look_around<Pack<double>>, keep_right<Pack<double>>, decide_freely<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline planner {
void look_around(const RobotColumns& robots, DecisionColumns& columns) {
  kKernels->look_around(robots, columns);
}

void keep_right(const RobotColumns& robots, DecisionColumns& columns) {
  kKernels->keep_right(robots, columns);
}

void decide_freely(const StepLaw& law, const Execution& execution, const RobotColumns& robots,
                   DecisionColumns& columns) {
  kKernels->decide_freely(law, execution, robots, columns);
}

void DecisionColumns::reserve(std::size_t robots) {
  state.resize(std::max(state.size(), robots));
  if (last_y.size() >= robots + kSpareNeighbors) return;  // this column grows last
  for (Column* column :
       {&range,          &ahead,  &is_beside, &push_x,   &push_y,   &push_at_rest_x,
        &push_at_rest_y, &wish_x, &wish_y,    &target_x, &target_y, &violation,
        &next_x,         &next_y, &new_x,     &new_y,    &a_x,      &a_y,
        &is_free,        &aim_x,  &aim_y,     &last_x,   &last_y}) {
    column->resize(robots + kSpareNeighbors, 1.0);
  }
}

}  // namespace avo::inline planner
