// SPDX-License-Identifier: Apache-2.0
// The soft half-spaces of moving obstacles, which leave all avoidance to the robot (docs/movers.md,
// "Towards movers").
#pragma once
#include <span>
#include <vector>

#include "avo/horizon.h"
#include "avo/planner.h"
#include "avo/space/mover.h"
#include "avo/space/robot.h"
#include "space/program.h"

namespace avo::space {

/// Appends them, in v', m/s, in space.
void append_mover_planes(const Robot& robot, std::span<const Mover> movers,
                         const PlannerOptions& options, const Horizon& horizon,
                         std::vector<HalfSpace>& half_spaces);

}  // namespace avo::space
