// SPDX-License-Identifier: Apache-2.0
// Which gaps belong to one narrow passage (docs/navigation.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "navigation/gaps.h"

namespace avo::inline navigation {

/// Gaps, and pairs of gaps between which the free space is nowhere wider.
struct GapPairs {
  std::vector<Gap> gaps;
  // of each gap: the range in which others are searched for, see range_of()
  std::vector<std::uint8_t> range;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;  // the lower number first
  std::size_t tested = 0;                                       // pairs that were tested anew
};

GapPairs pair_gaps(const ClearanceGrid& grid, std::vector<Gap> gaps);
/// The same result, sooner. number: the present number of each earlier gap, or kNoGap; the order
/// stays.
GapPairs pair_gaps(const ClearanceGrid& grid, std::vector<Gap> gaps, const GapPairs& before,
                   const WallChanges& changes, const std::vector<std::uint32_t>& number);

}  // namespace avo::inline navigation
