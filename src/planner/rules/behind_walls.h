// SPDX-License-Identifier: Apache-2.0
// Neighbors that walls keep away do not count
// (docs/certificate/walls.md, "Neighbors behind walls").
#pragma once
#include <span>

#include "avo/planner.h"
#include "certificate/braking_path.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// Removes from the robots' neighbors each robot that decides as well and is behind a wall. Neither
/// robot can then come round an end of the wall before both have stopped. Only walls that the robot
/// itself can touch are tested. Without a certificate, and with sensing errors, all neighbors
/// count; neighbors with an age always count.
void leave_out_hidden(const PlannerOptions& options, const StepLaw& law, Tile& tile);

/// Returns whether it removes the neighbor.
bool is_hidden(const Robot& robot, const Neighbor& neighbor, std::span<const Wall> walls,
               const StepLaw& law);

/// Returns whether the robot at its max_speed could touch any of them, by one step and braking.
bool is_beside(const Robot& robot, std::span<const Wall> walls, const StepLaw& law);

}  // namespace avo::inline planner
