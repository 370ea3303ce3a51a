// SPDX-License-Identifier: Apache-2.0
// The grid search for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "neighbors/search.h"

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

std::size_t collect_lanes(const Search& search, const PlacedPoints& points,
                          SearchScratch& scratch) {
  return collect<Pack<double>>(search, points, scratch);
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
HWY_EXPORT(collect_lanes);
#endif

std::size_t collect(const Search& search, const PlacedPoints& points, SearchScratch& scratch) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(collect_lanes)(search, points, scratch);
#endif
  return scalar::collect<scalar::Pack<double>>(search, points, scratch);
}

}  // namespace

void SearchScratch::grow(std::size_t size) {
  for (std::vector<double>* column : {&distance_squared, &place, &rank}) column->resize(size);
  hits.resize(size);
}

std::span<const NeighborHit> search_within(const Search& search, const PlacedPoints& points,
                                           SearchScratch& scratch) {
  const std::size_t count = collect(search, points, scratch);
  if (count <= kFewHits) {
    for (std::size_t k = 0; k < count; ++k) {
      scratch.hits[static_cast<std::size_t>(scratch.rank[k])] = candidate(points, scratch, k);
    }
    settle_ties(std::span(scratch.hits.data(), count));
  } else {
    for (std::size_t k = 0; k < count; ++k) scratch.hits[k] = candidate(points, scratch, k);
    std::sort(scratch.hits.begin(), scratch.hits.begin() + static_cast<std::ptrdiff_t>(count));
  }
  const double near_squared = squared(search.near);
  std::size_t kept = std::min(count, search.most);
  while (kept < count && scratch.hits[kept].distance_squared <= near_squared) ++kept;
  return {scratch.hits.data(), kept};
}

}  // namespace avo
#endif
