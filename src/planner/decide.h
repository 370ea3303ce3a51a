// SPDX-License-Identifier: Apache-2.0
// The plans of method avo, from the targets of the program.
#pragma once
#include "avo/planner.h"
#include "planner/execution.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// Makes the plans of the tile's robots: for nearly all robots in lanes, for the others one by one.
void decide(const Planner& planner, const Execution& execution, Tile& tile,
            PlanWorkspace::Scratch& scratch);

}  // namespace avo::inline planner
