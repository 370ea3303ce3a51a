// SPDX-License-Identifier: Apache-2.0
#include "space/kernels.h"

#define AVO_KERNEL_HEADER "space/look_kernel.h"
#define AVO_KERNEL_HEADER_2 "space/half_space_kernel.h"
#define AVO_KERNEL_STRUCT space::SpaceKernels
#define AVO_KERNEL_FUNCTIONS                                                                      \
  fill_own<Pack<double>>, append_in_space<Pack<double>>, hold<Pack<double>>, keeps<Pack<double>>, \
      fill_braking<Pack<double>>, find_seen<Pack<double>>, examine_seen<Pack<double>>,            \
      find_pairs<Pack<double>>, find_frames<Pack<double>>, turn_back<Pack<double>>,               \
      find_violations<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::space {

const SpaceKernels& kernels() {
  return *kKernels.operator->();
}

}  // namespace avo::space
