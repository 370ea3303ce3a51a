// SPDX-License-Identifier: Apache-2.0
// Noise for every instruction set; the best one is chosen at run time.
#include "core/noise.h"

#include "core/elementary.h"

namespace avo::inline core {
struct NoiseKernels {
  bool (*draw_gaussian)(std::uint64_t, std::uint64_t, double, GaussianDraws&);
};
}  // namespace avo::inline core

#define AVO_KERNEL_HEADER "core/noise_kernel.h"
#define AVO_KERNEL_STRUCT NoiseKernels
#define AVO_KERNEL_FUNCTIONS draw_gaussian<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline core {

// The library's own exponential function decides, and is called only where necessary.
void draw_gaussian(std::uint64_t key, std::uint64_t first, double most, GaussianDraws& draws) {
  if (kKernels->draw_gaussian(key, first, most, draws)) return;
  for (std::size_t k = 0; k < GaussianDraws::kTogether; ++k) {
    if (draws.taken[k] >= 0) continue;
    const double x = draws.x[k], u = uniform_number(key, first + 2 * k + 1);
    draws.taken[k] = u < 1.0 + elementary::expm1(-0.5 * x * x) ? 1 : 0;
  }
}

}  // namespace avo::inline core
