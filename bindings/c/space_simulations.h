// SPDX-License-Identifier: Apache-2.0
// The simulations of space behind their ids.
#pragma once
#include "avo/space/events.h"
#include "avo/space/simulation.h"
#include "avo_c/space.h"
#include "handles.h"
#include "ids.h"
#include "watch.h"

namespace avo_c {

struct SpaceSimulation : avo::space::Simulation {
  using avo::space::Simulation::Simulation;
  Watch<avo::space::Events> watch;
};

inline AVO_C_CONSTINIT Handles<avo_space_simulation_id, SpaceSimulation> fleets("space simulation");

/// The id in C++ of a robot that is there. Throws Failure for another id.
inline avo::RobotId present(const avo::space::Simulation& fleet, avo_robot_id robot) {
  if (robot.value == 0 || robot.value > fleet.size()) fail_absent(robot);
  return from_c(robot);
}

}  // namespace avo_c
