// SPDX-License-Identifier: Apache-2.0
// A scene and its simulation, in the words of the judge of recorded motion.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/check.h"
#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/simulation.h"

namespace avo {

/// What a robot of a scene is held to, where velocities do not change at once.
AVO_API CheckedRobot checked_robot(const RobotSetup& robot);

/// The present row of one robot, by its index, and by its id as its number.
AVO_API CheckedState checked_state(const FleetView& fleet, std::size_t robot);

/// The present rows of all robots, numbered by their ids.
AVO_API std::vector<CheckedState> checked_states(const FleetView& fleet);

}  // namespace avo
