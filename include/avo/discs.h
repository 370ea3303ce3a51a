// SPDX-License-Identifier: Apache-2.0
// The discs of a robot as others keep clear of them.
#pragma once
#include <vector>

#include "avo/export.h"
#include "avo/geometry.h"
#include "avo/scenario.h"

namespace avo {

/// Returns the discs of a robot's footprint, or its one disc, for a robot at that place; heading in
/// rad.
AVO_API std::vector<Disc> discs_at(const RobotSetup& robot, Vec2 position, double heading);

}  // namespace avo
