// SPDX-License-Identifier: Apache-2.0
// Puts the robots of a step in order, and takes the snapshot that they sense.
#pragma once
#include "core/executor.h"

namespace avo::inline sim {

struct World;

/// Notes the cell of each robot.
void note_cells(World& world, Executor& executor);

/// Files robots and moving obstacles by place, as they are now, and collects the claims of
/// passages.
void index(World& world, Executor& executor);

/// Prepares what sense_everyone() needs between two steps. No robot moves.
void look_at_present(World& world);

}  // namespace avo::inline sim
