// SPDX-License-Identifier: Apache-2.0
// Niches beside a route, which robots do not pass through.
#pragma once
#include "navigation/gaps.h"

namespace avo::inline navigation {

/// Returns whether there is room for a robot on one side of the gap, and no route on from there.
/// Only robots with a goal there pass such a gap. A gap of two lanes never leads into a pocket.
bool leads_into_pocket(const ClearanceGrid& grid, const Gap& gap);

}  // namespace avo::inline navigation
