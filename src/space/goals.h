// SPDX-License-Identifier: Apache-2.0
// The preferred velocity towards a goal in space: the landing of the plane, along the route.
#pragma once
#include "avo/space/robot.h"
#include "core/response_law.h"

namespace avo::space {

/// The values of a planner that landings depend on.
struct Landing {
  ResponseLaw law;
  double lag = 0.05;          ///< s, see StepLaw
  double braking_time = 0.1;  ///< s, see StepLaw
};

/// m/s: towards the goal with at most that speed, so that braking ends there.
Vec3 preferred_velocity(const Robot& robot, Vec3 goal, double preferred_speed,
                        const Landing& landing);

}  // namespace avo::space
