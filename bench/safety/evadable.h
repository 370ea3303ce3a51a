// SPDX-License-Identifier: Apache-2.0
// Whether anybody could have come through untouched: by brute force, of which the library knows
// nothing.
#pragma once
#include "avo/scenario.h"

namespace avo::safety {

/// Whether a holonomic robot like the scene's first one can keep clear of its moving obstacles
/// until the scene ends: thousands of states at a time, each with its velocity, go on by
/// accelerations that are held for about 0.2 s. Yes is proof up to 1/40 s of motion; no is that
/// none was found. Walls and other robots are left out.
bool is_evadable(const Scenario& scenario);

}  // namespace avo::safety
