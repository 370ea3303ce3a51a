// SPDX-License-Identifier: Apache-2.0
// Joins the gaps of one narrow route to a passage (docs/navigation.md).
#pragma once
#include <cstdint>
#include <vector>

#include "navigation/gap_pairs.h"
#include "navigation/passages.h"

namespace avo::inline navigation {

/// A passage ends where it widens, and where it branches. The function also gives the gaps as
/// lines, each with the direction of the axis to its left, and the passage of each.
std::vector<Passage> join_gaps(const GapPairs& pairs, std::vector<Wall>& lines,
                               std::vector<std::uint32_t>& passage_of);

}  // namespace avo::inline navigation
