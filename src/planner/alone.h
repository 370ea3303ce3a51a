// SPDX-License-Identifier: Apache-2.0
// A robot that is planned alone: a tile of one.
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/wall.h"

namespace avo::inline planner {

/// Makes the robot the only one of scratch.alone, with its neighbors nearest first and its walls.
/// Returns false where a number of them is out of range. The tile refers to the robot and the
/// walls.
bool take_alone(const Robot& robot, std::span<const Neighbor> neighbors,
                std::span<const Wall> walls, PlanWorkspace::Scratch& scratch);

/// Planner::plan(), with a trace.
template <typename Trace>
Plan plan_alone(const Planner& planner, const Robot& robot, std::span<const Neighbor> neighbors,
                PlanWorkspace& workspace, Detour* detour, std::span<const Wall> walls, Trace trace);

}  // namespace avo::inline planner
