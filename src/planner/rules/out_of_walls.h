// SPDX-License-Identifier: Apache-2.0
// Leads a robot out of walls, if it was put or pushed into one (docs/navigation.md, "Inside of
// walls").
#pragma once
#include <optional>
#include <span>

#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"

namespace avo::inline planner {

/// m: a place clear of all walls that the robot reaches straight ahead, on its own side of each
/// wall. It is the nearest place where a single wall or a corner blocks the robot, and else a near
/// place. None where it finds none.
std::optional<Vec2> place_outside(const Robot& robot, std::span<const Wall> walls);

/// m/s, the velocity with which a robot leaves the walls that it is in: the robot can still stop
/// where it is clear of them. It is 0 where the robot is in no wall, and between walls that leave
/// it no escape.
Vec2 velocity_out(const Robot& robot, std::span<const Wall> walls, const StepLaw& law);

}  // namespace avo::inline planner
