// SPDX-License-Identifier: Apache-2.0
// Ways and motion in lanes, for every instruction set; the fittest is chosen at run time.
#include "sim/moving_columns.h"

namespace avo {
struct MovingKernels {
  void (*choose_ways)(const GoalLaw&, const MovingColumns&, RobotColumns&);
  std::uint64_t (*advance)(const StepResponse&, MovingColumns&, RobotColumns&);
};
}  // namespace avo

#define AVO_KERNEL_HEADER "sim/moving_kernel.h"
#define AVO_KERNEL_STRUCT MovingKernels
#define AVO_KERNEL_FUNCTIONS choose_ways<Pack<double>>, advance<Pack<double>>
#include "core/kernel_passes.h"

namespace avo {
void choose_ways(const GoalLaw& law, const MovingColumns& moving, RobotColumns& robots) {
  kKernels->choose_ways(law, moving, robots);
}

std::uint64_t advance(const StepResponse& response, MovingColumns& moving, RobotColumns& robots) {
  return kKernels->advance(response, moving, robots);
}

}  // namespace avo
