// SPDX-License-Identifier: Apache-2.0
// The plans of method avo, from the targets of the program.
#pragma once
#include <cstddef>

#include "avo/model.h"
#include "avo/planner.h"
#include "planner/stages/execution.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// Returns whether the robot cannot rest.
inline bool flies(const RobotColumns& robots, std::size_t i) {
  return robots.model[i] != nullptr && !can_rest(*robots.model[i]);
}

/// Makes the plans of the tile's robots: for nearly all robots in lanes, for the others one by one.
template <typename Trace>
void decide(const Planner& planner, const Execution& execution, Tile& tile,
            PlanWorkspace::Scratch& scratch, Trace trace);

}  // namespace avo::inline planner
