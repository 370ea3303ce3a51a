// SPDX-License-Identifier: Apache-2.0
// What a scene breaks of what its certificate assumes, in words.
#pragma once
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"

namespace avo_io {

/// A line on each thing that avo::broken_assumptions() finds, and what to change, e.g. by options
/// of the command line; none where nothing is broken.
AVO_API std::vector<std::string> complaints(const avo::Scenario& scenario);

}  // namespace avo_io
