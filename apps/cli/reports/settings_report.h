// SPDX-License-Identifier: Apache-2.0
// The output of --verbose, on the standard error output.
#pragma once
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo/simulation.h"
#include "verbs/verbs.h"

namespace avo_cli {

/// Tells which scene is loaded, from where, with which files, and the settings in use. Settings
/// that the scene leaves out are those of its method. Prints nothing unless --verbose is set.
void tell_settings(const SceneArguments& arguments, const avo::Scenario& scenario,
                   const avo_io::SceneSource& source);

/// Tells threads, instruction set and version. Prints nothing unless --verbose is set.
void tell_machine(const avo::Simulation& simulation);

}  // namespace avo_cli
