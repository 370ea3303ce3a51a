// SPDX-License-Identifier: Apache-2.0
// Preferred velocities and motion in lanes, for every instruction set; the best one is chosen at
// run time.
#include "sim/columns/moving_columns.h"

namespace avo::inline sim {
struct MovingKernels {
  void (*choose_preferred)(const StepResponse&, const MovingColumns&, RobotColumns&);
  std::uint64_t (*advance)(const StepResponse&, MovingColumns&, RobotColumns&);
};
}  // namespace avo::inline sim

#define AVO_KERNEL_HEADER "sim/moving_kernel.h"
#define AVO_KERNEL_STRUCT MovingKernels
#define AVO_KERNEL_FUNCTIONS choose_preferred<Pack<double>>, advance<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline sim {

void choose_preferred(const StepResponse& step, const MovingColumns& moving, RobotColumns& robots) {
  kKernels->choose_preferred(step, moving, robots);
}

std::uint64_t advance(const StepResponse& response, MovingColumns& moving, RobotColumns& robots) {
  return kKernels->advance(response, moving, robots);
}

}  // namespace avo::inline sim
