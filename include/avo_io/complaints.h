// SPDX-License-Identifier: Apache-2.0
// The assumptions of a certificate that a scene breaks, in the words of the command line.
#pragma once
#include <string>
#include <vector>

#include "avo/assumptions.h"

namespace avo_io {

/// Returns one line for each thing that avo::broken_assumptions() finds, with what to change, e.g.
/// by options of the command line; none where nothing is broken.
inline std::vector<std::string> complaints(const avo::Scenario& scenario) {
  return avo::complaints(scenario, {"--start-at-rest", "--limit-speed"});
}

}  // namespace avo_io
