// SPDX-License-Identifier: Apache-2.0
// Scenes and simulations of space for Python.
#pragma once
#include <string>
#include <utility>

#include "avo/space/simulation.h"
#include "bind.h"
#include "shared.h"

namespace avo_python {

/// Returns the scenario of space of a path, a dict, or a Scenario itself, as scenario_of().
avo::space::Scenario scenario_of_space(const py::object& source, const py::object& overrides);

using SharedSpaceSimulation = Shared<avo::space::Simulation>;

namespace space {

using SpaceSimulationClass = py::class_<SharedSpaceSimulation>;
void bind_moving_obstacles(py::module_& space);
void bind_edits(SpaceSimulationClass& simulation);

/// Throws Error unless there is a robot of that id.
avo::RobotId checked(const avo::space::Simulation& simulation, std::int64_t robot);

}  // namespace space

}  // namespace avo_python
