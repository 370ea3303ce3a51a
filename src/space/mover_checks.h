// SPDX-License-Identifier: Apache-2.0
// What a scene of space says of moving obstacles: its ranges, and how far robots have to see.
#pragma once
#include <span>
#include <string>

#include "avo/ids.h"
#include "avo/space/planner.h"
#include "avo/space/scenario.h"
#include "certificate/braking_path.h"

namespace avo::space {

/// Throws Error that names the first value out of range.
void check_moving_obstacles(const Scenario& scenario);

/// The same for one of them; key: stands in front of the names of its values.
void check_moving_obstacle(const MovingObstacle& obstacle, const std::string& key);

/// Throws Error that names the first robot and moving obstacle that touch, or come to touch if the
/// robot brakes from now on. Error of sensing does not count. The ids of robots are their places.
void check_mover_starts(std::span<const Robot> robots, std::span<const Mover> movers,
                        std::span<const MovingObstacleId> ids, StepLaw law);

/// m: the distance within which robots like `largest` have to sense every moving obstacle of the
/// scene while it runs; 0 without them.
double mover_range(const Scenario& scenario, const Robot& largest, const PlannerOptions& options);
/// The same for the largest values of any robot of the scene.
double mover_range(const Scenario& scenario);

}  // namespace avo::space
