// SPDX-License-Identifier: Apache-2.0
// Niches beside a way, which robots do not pass through.
#pragma once
#include "navigation/gaps.h"

namespace avo::inline navigation {

/// Whether there is room for a robot on one side of the gap, and it gets nowhere from there: nobody
/// wants through who has not its goal there. A gap of two lanes never leads into a pocket.
bool leads_into_pocket(const ClearanceGrid& grid, const Gap& gap);

}  // namespace avo::inline navigation
