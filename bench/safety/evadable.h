// SPDX-License-Identifier: Apache-2.0
// Whether any robot could have come through without contact: by brute force, independent of the
// library.
#pragma once
#include "avo/scenario.h"

namespace avo::safety {

/// Returns whether a holonomic robot like the scene's first one can keep clear of its moving
/// obstacles until the scene ends. Thousands of states at a time, each with its velocity, advance
/// by accelerations that are held for about 0.2 s. True is a proof up to 1/40 s of motion; false
/// means that no evasion was found. Walls and other robots are ignored.
bool is_evadable(const Scenario& scenario);

}  // namespace avo::safety
