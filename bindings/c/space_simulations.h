// SPDX-License-Identifier: Apache-2.0
// The simulations of space behind their ids.
#pragma once
#include <cstddef>
#include <string>

#include "avo/space/simulation.h"
#include "avo_c/space.h"
#include "handles.h"

namespace avo_c {

inline AVO_C_CONSTINIT Handles<avo_space_simulation_id, avo::space::Simulation> fleets(
    "space simulation");

/// The number of a robot that there is. Throws Failure for another number.
inline std::size_t checked(const avo::space::Simulation& fleet, std::size_t robot) {
  if (robot >= fleet.size())
    fail(AVO_ERROR_INVALID_ARGUMENT,
         "robot: found " + std::to_string(robot) + ", must be < " + std::to_string(fleet.size()));
  return robot;
}

}  // namespace avo_c
