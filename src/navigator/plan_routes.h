// SPDX-License-Identifier: Apache-2.0
// Makes the route of a mission, from where the robot is.
#pragma once
#include "navigator/state.h"

namespace avo::inline navigator {

RouteRules route_rules_of(const NavigatorOptions& options);

/// Makes the route where there is none for the mission, or for the robot's radius.
void plan_routes(NavigatorState& state, Memory& memory, const Robot& robot);

/// m: the smallest circle that the robot can drive on; 0: it turns on the spot.

/// m: where the route ends.
Vec2 end_of(const Mission& mission, const Memory& memory);

/// How the robot follows a given route.
Pursuit pursuit_of(const NavigatorState& state, const Robot& robot);

}  // namespace avo::inline navigator
