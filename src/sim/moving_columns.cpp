// SPDX-License-Identifier: Apache-2.0
// Ways and motion in lanes, for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "sim/moving_columns.h"

#include "core/kernel_table.h"
#include "planner/relevance.h"
#include "sim/moving_kernel.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/moving_columns.cpp"
#include <hwy/foreach_target.h>
#if HWY_TARGET & AVO_TARGETS
#include "core/lanes.h"  // begins the pass
#include "sim/moving_kernel.h"

AVO_BEGIN_KERNELS
constexpr MovingKernels kKernels{choose_ways<Pack<double>>, advance<Pack<double>>};
AVO_END_KERNELS
#endif
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace scalar {
constexpr MovingKernels kKernels{choose_ways<Pack<double>>, advance<Pack<double>>};
}  // namespace scalar

static constexpr KernelTable<MovingKernels> kKernels = AVO_KERNEL_TABLE(kKernels);

void choose_ways(const GoalLaw& law, const MovingColumns& moving, RobotColumns& robots) {
  kKernels->choose_ways(law, moving, robots);
}

std::uint64_t advance(const StepResponse& response, MovingColumns& moving, RobotColumns& robots) {
  return kKernels->advance(response, moving, robots);
}

}  // namespace avo
#endif
