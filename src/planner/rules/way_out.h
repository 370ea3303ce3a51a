// SPDX-License-Identifier: Apache-2.0
// Out of walls: of a robot that was put into one, or pushed (docs/navigation.md, "Inside of
// walls").
#pragma once
#include <optional>
#include <span>

#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"

namespace avo::inline planner {

/// m: a place clear of all walls that the robot gets to straight ahead, on its own side of each:
/// the nearest one where a single wall or a corner is in its way, and else one that is near. None
/// where it finds none.
std::optional<Vec2> place_outside(const Robot& robot, std::span<const Wall> walls);

/// m/s, with which a robot leaves the walls that it is in: from it the robot can still stop where
/// it is clear of them. 0 where it is in none, and between walls that leave it no way out.
Vec2 velocity_out(const Robot& robot, std::span<const Wall> walls, const StepLaw& law);

}  // namespace avo::inline planner
