// SPDX-License-Identifier: Apache-2.0
// The grid search for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "neighbors/search.h"

#include <algorithm>

#include "core/simd_target.h"
#include "neighbors/search_steps.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "neighbors/search.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include "core/lanes.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
#include "neighbors/search_kernel.h"

std::size_t find_in_lanes(const PlacedPoints& points, std::size_t enough, SearchScratch& scratch) {
  return find_candidates<Pack<double>, Pack<float>>(points, enough, scratch);
}
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace scalar {
#include "neighbors/search_kernel.h"
}  // namespace scalar
namespace {

#ifdef AVO_HIGHWAY
HWY_EXPORT(find_in_lanes);
#endif

}  // namespace

void SearchScratch::grow(std::size_t size) {
  size = std::max(size, order.size() + order.size() / 2);
  distance_squared.resize(size);
  for (std::vector<std::uint32_t>* column : {&place, &rank, &order}) column->resize(size);
}

std::size_t search_within(const PlacedPoints& points, std::size_t enough, SearchScratch& scratch) {
  scratch.used = 0;
  scratch.found.resize(scratch.queries.size());
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(find_in_lanes)(points, enough, scratch);
#endif
  return scalar::find_candidates<scalar::Pack<double>, scalar::Pack<float>>(points, enough,
                                                                            scratch);
}

}  // namespace avo
#endif
