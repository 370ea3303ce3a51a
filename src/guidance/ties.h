// SPDX-License-Identifier: Apache-2.0
// Exactly symmetric scenes, such as a circle, in which all robots would do the same: their ids
// break the symmetry (docs/arrival.md, rule 1).
#pragma once
#include "avo/planner.h"
#include "avo/simulation.h"

namespace avo::inline guidance {

/// Breaks the tie of a robot of method avo that is not used to any traffic yet. Its two nearest
/// neighbors must be at the same distance. It gets used to a little traffic, by its id. The
/// arguments are squares of the distances, in order, m².
void break_tie(RobotId robot, double nearest_squared, double next_squared, Detour& detour);

}  // namespace avo::inline guidance
