// SPDX-License-Identifier: Apache-2.0
// Robots that are planned together: alone each decides the same, but their half-planes and programs
// then share lanes.
#pragma once
#include <cstddef>

#include "avo/planner.h"
#include "core/stage_clock.h"
#include "planner/soft_planes.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// Planner::plan() of each. Not for method velocity_obstacle. The robots that decide by half-planes
/// become the first tile.robots.count of the tile, whose order may change.
void plan_together(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch,
                   StageClock& clock);

/// Room for so many robots with at most so many half-planes each, and in all, among at most so many
/// neighbors each, and in all, which brake for at most so many steps.
void reserve_together(std::size_t robots, std::size_t planes_each, std::size_t planes,
                      std::size_t neighbors_each, std::size_t neighbors, std::size_t braking_steps,
                      PlanWorkspace::Scratch& scratch);

}  // namespace avo::inline planner
