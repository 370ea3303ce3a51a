// SPDX-License-Identifier: Apache-2.0
// The wishes of the robots of a tile, and what the program is given for them.
#pragma once
#include <optional>

#include "planner/decision_columns.h"
#include "planner/stages/disc_pairs.h"
#include "planner/stages/execution.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// What the nearest discs of a neighbor and A push A by, see push_of(); none where they are not
/// beside each other.
std::optional<Vec2> push_within(const DiscPair& pair);

/// Makes the wish of each robot; for method avo the rules for arriving turn it (docs/arrival.md).
template <typename Trace>
void make_wishes(const Planner& planner, const Tile& tile, DecisionColumns& decisions, Trace trace);

/// Makes the velocities that Eq. (23) is given in place of the wishes of gentle robots, and the
/// changes in their last steps. On the route it is a part of the change to the wish, see
/// unhurried_part(). Where a robot comes to rest, it is the change that leads there in one step.
void make_aims(const Planner& planner, const Execution& execution, const Tile& tile,
               DecisionColumns& decisions);

}  // namespace avo::inline planner
