// SPDX-License-Identifier: Apache-2.0
// Adds, changes and removes moving obstacles of space between steps.
#pragma once
#include "avo/ids.h"
#include "avo/space/mover.h"
#include "space/fleet.h"

namespace avo::space {

/// See the functions of these names of Simulation. Where they throw, nothing has changed.
MovingObstacleId add_moving_obstacle(SpaceFleet& fleet, const MovingObstacle& obstacle);
void change_moving_obstacle(SpaceFleet& fleet, MovingObstacleId id, const MovingObstacle& obstacle);
void remove_moving_obstacle(SpaceFleet& fleet, MovingObstacleId id);

}  // namespace avo::space
