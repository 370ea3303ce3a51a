// SPDX-License-Identifier: Apache-2.0
// The grid search for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "neighbors/search.h"

#include <algorithm>

#include "core/kernel_table.h"
#include "neighbors/search_kernel.h"
#include "neighbors/search_steps.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "neighbors/search.cpp"
#include <hwy/foreach_target.h>
#if HWY_TARGET & AVO_TARGETS
#include "core/lanes.h"  // begins the pass
#include "neighbors/search_kernel.h"

AVO_BEGIN_KERNELS
constexpr SearchKernels kKernels{find_candidates<Pack<double>, Pack<float>>};
AVO_END_KERNELS
#endif
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace scalar {
constexpr SearchKernels kKernels{find_candidates<Pack<double>, Pack<float>>};
}  // namespace scalar

static constexpr KernelTable<SearchKernels> kKernels = AVO_KERNEL_TABLE(kKernels);

void SearchScratch::grow(std::size_t size) {
  size = std::max(size, order.size() + order.size() / 2);
  distance_squared.resize(size);
  place.resize(size);
  order.resize(size);
}

std::size_t search_within(const PlacedPoints& points, std::size_t enough, SearchScratch& scratch) {
  scratch.used = 0;
  scratch.found.resize(scratch.queries.size());
  return kKernels->find_candidates(points, enough, scratch);
}

}  // namespace avo
#endif
