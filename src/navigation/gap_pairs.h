// SPDX-License-Identifier: Apache-2.0
// Which gaps are of one narrow way (docs/navigation.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "navigation/gaps.h"

namespace avo::inline navigation {

/// Gaps, and pairs of them between which the way is nowhere wider.
struct GapPairs {
  std::vector<Gap> gaps;
  std::vector<std::uint8_t> range;  // of each gap: how far others are looked for, see range_of()
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;  // the lower number first
  std::size_t tested = 0;                                       // pairs that were looked at anew
};

GapPairs pair_gaps(const ClearanceGrid& grid, std::vector<Gap> gaps);
/// The same, sooner. number: of each gap before, the one that it has now, or kNoGap; all of one
/// order.
GapPairs pair_gaps(const ClearanceGrid& grid, std::vector<Gap> gaps, const GapPairs& before,
                   const WallChanges& changes, const std::vector<std::uint32_t>& number);

}  // namespace avo::inline navigation
