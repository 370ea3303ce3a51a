// SPDX-License-Identifier: Apache-2.0
// Where the robots of a tile wish to go, and what the program is given for that.
#pragma once
#include "planner/decision_columns.h"
#include "planner/execution.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// What each robot wishes for: with method avo as the rules for arriving turn it (docs/arrival.md).
void make_wishes(const Planner& planner, const Tile& tile, DecisionColumns& decisions);

/// What Eq. (23) is given in place of the wishes of gentle robots, and what their last steps have
/// done. On the way it is a part of what leads to the wish, see unhurried_part(), and where they
/// land what leads there in one step.
void make_aims(const Planner& planner, const Execution& execution, const Tile& tile,
               DecisionColumns& decisions);

}  // namespace avo::inline planner
