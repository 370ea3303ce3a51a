// SPDX-License-Identifier: Apache-2.0
// A scene and its simulation, in the words of the judge of recorded motion.
#pragma once
#include <vector>

#include "avo/check.h"
#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/simulation.h"

namespace avo {

/// What a robot of a scene is held to, where velocities do not change at once.
AVO_API CheckedRobot checked_robot(const RobotSetup& robot);

/// The present rows of all robots, numbered by their ids.
AVO_API std::vector<CheckedState> checked_states(const FleetView& fleet);

}  // namespace avo
