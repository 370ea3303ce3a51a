// SPDX-License-Identifier: Apache-2.0
// The grid search for every instruction set; the best one is chosen at run time.
#include "spatial/search.h"

#include <algorithm>

#include "spatial/search_steps.h"

#define AVO_KERNEL_HEADER "spatial/search_kernel.h"
#define AVO_KERNEL_STRUCT SearchKernels
#define AVO_KERNEL_FUNCTIONS find_candidates<Pack<double>, Pack<float>>
#include "core/kernel_passes.h"

namespace avo::inline spatial {
void SearchScratch::grow(std::size_t size) {
  size = std::max(size, order.size() + order.size() / 2);
  distance_squared.resize(size);
  place.resize(size);
  keys.resize(size);
  order.resize(size);
}

std::size_t search_within(const PlacedPoints& points, std::size_t enough, SearchScratch& scratch) {
  scratch.used = 0;
  scratch.results.resize(scratch.queries.size());
  return kKernels->find_candidates(points, enough, scratch);
}

}  // namespace avo::inline spatial
