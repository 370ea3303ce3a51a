// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "avo/vec.h"
#include "core/robot_columns.h"

namespace avo::inline robots {

/// elementary::direction() of a robot's heading, rad. Each stage of a step asks for the headings of
/// the same robots; each thread caches its recent results.
Vec2 ahead_of(double heading);
/// Finds the directions of all these robots that have a model, in lanes; ahead_of() then knows
/// them.
void look_ahead(const RobotColumns& robots);

}  // namespace avo::inline robots
