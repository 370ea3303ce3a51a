// SPDX-License-Identifier: Apache-2.0
// The preferred velocity of a robot that comes to rest at its goal.
#pragma once
#include "guidance/traits.h"
#include "robots/motion.h"

namespace avo::inline guidance {

/// [v_A^pref] m/s: towards the goal at preferred_speed (the paper's), until the distance left is
/// the braking distance. Then it is the v' with the highest next speed that still stops at the
/// goal. Without other robots the robot comes to rest on the goal. The robot does not overshoot and
/// does not oscillate, at any δ. v' leads the velocity by the lag of the controller. So v' points
/// away from the goal near it.
Vec2 preferred_velocity(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
                        const StepResponse& step);

}  // namespace avo::inline guidance
