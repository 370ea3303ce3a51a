// SPDX-License-Identifier: Apache-2.0
// How far ahead a robot looks for its half-spaces: less far near its goal (docs/space.md,
// "Arriving").
#pragma once
#include <span>
#include <vector>

#include "avo/horizon.h"
#include "avo/planner.h"
#include "avo/space/robot.h"

namespace avo::space {

/// The horizons of these options, from the full one down to the shortest one.
std::vector<Horizon> horizons_of(const PlannerOptions& options);

/// The horizon of the half-spaces of neighbors, one of horizons_of().
const Horizon& horizon_of(const Robot& robot, std::span<const Horizon> horizons);

}  // namespace avo::space
