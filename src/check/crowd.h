// SPDX-License-Identifier: Apache-2.0
// Robots whose goals leave no room for all of them, and who rest around the place.
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "avo/check.h"

namespace avo::judge {

/// Whether the robot rests, another one rests so near its goal that the two could not be there
/// both, and others at rest lead from the one to the other, so close that the robot does not get
/// through between them. The goals of the two are as close together, so neither is on its way
/// elsewhere. goal: m, of its disc. places: m, by robot, of the discs of those at rest.
bool rests_at_crowd(std::size_t robot, Vec2 goal, std::span<const CheckedRobot> robots,
                    std::span<const std::optional<Vec2>> places);

}  // namespace avo::judge
