// SPDX-License-Identifier: Apache-2.0
// The preferred velocity towards a goal in space: the landing of the plane, along the route.
#pragma once
#include "avo/space/robot.h"
#include "space/tempo.h"

namespace avo::space {

/// m/s: towards the goal with at most that speed, so that braking ends there.
Vec3 preferred_velocity(const Robot& robot, Vec3 goal, double preferred_speed,
                        const Landing& landing, const Tempo& tempo);

}  // namespace avo::space
