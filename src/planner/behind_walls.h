// SPDX-License-Identifier: Apache-2.0
// Neighbors that walls keep away do not count
// (docs/certificate/walls.md, "Neighbors behind walls").
#pragma once
#include <span>

#include "avo/planner.h"
#include "certificate/braking_path.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// Takes out of the robots' neighbors whoever decides as well and is behind a wall, so that neither
/// can come round an end of it before both have stopped. Only walls that the robot itself could
/// come to touch are looked at. With sensing errors all neighbors count, and those of an age do in
/// any case.
void leave_out_hidden(const PlannerOptions& options, const StepLaw& law, Tile& tile);

/// Whether it takes the neighbor out.
bool is_hidden(const Robot& robot, const Neighbor& neighbor, std::span<const Wall> walls,
               const StepLaw& law);

/// Whether the robot at its max_speed could come to touch any of them, by one step and braking.
bool is_beside(const Robot& robot, std::span<const Wall> walls, const StepLaw& law);

}  // namespace avo::inline planner
