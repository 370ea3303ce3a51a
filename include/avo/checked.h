// SPDX-License-Identifier: Apache-2.0
// Turns a scene and its simulation into the types of the judge of recorded motion.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/check.h"
#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/simulation.h"

namespace avo {

/// Returns the limits of a robot of a scene, for methods that do not change velocities at once.
AVO_API CheckedRobot checked_robot(const RobotSetup& robot);

/// Returns the limits of a robot of that scene, by its motion and its method as well.
AVO_API CheckedRobot checked_robot(const Scenario& scenario, const RobotSetup& robot);

/// Returns the present row of the robot in that row of the columns; its number is that of its id.
AVO_API CheckedState checked_state(const FleetView& fleet, std::size_t robot);

/// Returns the present rows of all robots, numbered by their ids.
AVO_API std::vector<CheckedState> checked_states(const FleetView& fleet);

}  // namespace avo
