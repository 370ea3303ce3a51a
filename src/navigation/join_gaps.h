// SPDX-License-Identifier: Apache-2.0
// Gaps of one way make a passage (docs/navigation.md).
#pragma once
#include <cstdint>
#include <vector>

#include "navigation/gap_pairs.h"
#include "navigation/passages.h"

namespace avo::inline navigation {

/// A passage ends where it widens, and where it branches. Also the gaps as lines with the way along
/// the axis to their left, and the passage of each.
std::vector<Passage> join_gaps(const GapPairs& pairs, std::vector<Wall>& lines,
                               std::vector<std::uint32_t>& passage_of);

}  // namespace avo::inline navigation
