// SPDX-License-Identifier: Apache-2.0
// Turns of drives in lanes, for every instruction set; the best one is chosen at run time.
#include "robots/drive_turns.h"

namespace avo::inline robots {
struct DriveKernels {
  void (*turn)(DriveTurns&, double);
};
}  // namespace avo::inline robots

#define AVO_KERNEL_HEADER "robots/drive_kernel.h"
#define AVO_KERNEL_STRUCT DriveKernels
#define AVO_KERNEL_FUNCTIONS turn<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline robots {

void turn(DriveTurns& turns, double time) {
  turns.fill_up();
  kKernels->turn(turns, time);
}

}  // namespace avo::inline robots
