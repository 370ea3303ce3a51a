// SPDX-License-Identifier: Apache-2.0
// The routes of a whole fleet.
#pragma once
#include "avo/scenario.h"
#include "guidance/ways.h"
#include "sim/fleet.h"

namespace avo::inline sim {

WayRules way_rules_of(const Scenario& settings);

/// Plans the routes of all robots. before: their routes among other walls, see plan_anew().
/// arrival_distance: m, of robots that have none of their own.
void plan_travels(Ways& ways, const Fleet& fleet, double arrival_distance,
                  const Ways* before = nullptr);

}  // namespace avo::inline sim
