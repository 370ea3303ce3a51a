// SPDX-License-Identifier: Apache-2.0
// Directions in lanes, for every instruction set; the fittest is chosen at run time.
#include "robots/directions.h"

namespace avo::inline robots {
struct DirectionKernels {
  void (*find_directions)(const double*, std::size_t, double*, double*);
};
}  // namespace avo::inline robots

#define AVO_KERNEL_HEADER "robots/direction_kernel.h"
#define AVO_KERNEL_STRUCT DirectionKernels
#define AVO_KERNEL_FUNCTIONS find_directions<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline robots {

void find_directions(const double* angles, std::size_t count, double* x, double* y) {
  kKernels->find_directions(angles, count, x, y);
}

}  // namespace avo::inline robots
