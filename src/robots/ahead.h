// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "avo/vec.h"

namespace avo::inline robots {

/// elementary::direction() of a robot's heading, rad. Each stage of a step asks for the headings of
/// the same robots, and what this thread has been asked for lately it does not compute again.
Vec2 ahead_of(double heading);

}  // namespace avo::inline robots
