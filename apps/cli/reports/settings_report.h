// SPDX-License-Identifier: Apache-2.0
// What --verbose tells, on the standard error output.
#pragma once
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo/simulation.h"
#include "verbs/verbs.h"

namespace avo_cli {

/// Which scene is loaded, from where, with which files, and the settings in use, those of its
/// method where the scene leaves them out. Nothing unless it is to be verbose.
void tell_settings(const SceneArguments& arguments, const avo::Scenario& scenario,
                   const avo_io::SceneSource& source);

/// Threads, instruction set and version. Likewise.
void tell_machine(const avo::Simulation& simulation);

}  // namespace avo_cli
