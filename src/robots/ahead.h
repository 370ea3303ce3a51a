// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "avo/vec.h"

namespace avo::inline robots {

/// elementary::direction() of a robot's heading, rad. Each stage of a step asks for the headings of
/// the same robots; each thread caches its recent results.
Vec2 ahead_of(double heading);

}  // namespace avo::inline robots
