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

}  // namespace avo_python
