// SPDX-License-Identifier: Apache-2.0
// Robots that cannot go everywhere at once go about it in their own way.
#pragma once
#include "certificate/braking_path.h"
#include "planner/options.h"
#include "planner/tile.h"

namespace avo {

/// Makes of each preferred velocity what the robot can steer to, beside walls with maneuvers
/// (docs/arrival.md, rule 10). Only the wish depends on it. tile.maneuvers: who has one.
void steer(const PlannerOptions& options, const StepLaw& law, Tile& tile);

}  // namespace avo
