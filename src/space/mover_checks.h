// SPDX-License-Identifier: Apache-2.0
// What a scene of space says of moving obstacles: its ranges, and how far robots have to see.
#pragma once
#include <string>

#include "avo/space/planner.h"
#include "avo/space/scenario.h"

namespace avo::space {

/// Throws Error that names the first value out of range, and the first robot that a moving obstacle
/// touches at the start.
void check_moving_obstacles(const Scenario& scenario);

/// The same for one of them without robots; key: stands in front of the names of its values.
void check_moving_obstacle(const MovingObstacle& obstacle, const std::string& key);

/// m: the distance within which robots like `largest` have to sense every moving obstacle of the
/// scene while it runs; 0 without them.
double mover_range(const Scenario& scenario, const Robot& largest, const PlannerOptions& options);
/// The same for the largest values of any robot of the scene.
double mover_range(const Scenario& scenario);

}  // namespace avo::space
