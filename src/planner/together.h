// SPDX-License-Identifier: Apache-2.0
// Robots that are planned together: each decides as it does alone, but their half-planes and
// programs share lanes.
#pragma once
#include <cstddef>

#include "avo/planner.h"
#include "core/stage_clock.h"
#include "planner/stages/soft_planes.h"
#include "planner/tile.h"
#include "planner/trace.h"

namespace avo::inline planner {

/// Planner::plan() of each robot. Not for method velocity_obstacle. The robots that decide by
/// half-planes become the first tile.robots.count robots of the tile; its order may change. Where a
/// trace records, the tile has one robot.
template <typename Trace = NoTrace>
void plan_together(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch,
                   StageClock& clock, Trace trace = {});

/// Reserves room for so many robots, their half-planes and their neighbors, which brake for at most
/// so many steps. For half-planes and neighbors there is a limit for each robot and a limit for
/// all.
void reserve_together(std::size_t robots, std::size_t planes_each, std::size_t planes,
                      std::size_t neighbors_each, std::size_t neighbors, std::size_t braking_steps,
                      PlanWorkspace::Scratch& scratch);

}  // namespace avo::inline planner
