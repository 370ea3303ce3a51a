// SPDX-License-Identifier: Apache-2.0
// Robots with goals that leave no room for all of them, which rest around the place.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "avo/check.h"
#include "avo/space/check.h"

namespace avo::judge {

/// Returns whether the robot rests around its goal. Another robot must rest so near the goal that
/// both could not be there. Robots at rest must lead from one to the other, so close that the robot
/// does not fit through between them. The goals of the two must be equally close together, so
/// neither is on its route elsewhere. goal: m, of its disc. places: m, by robot, of the discs of
/// robots at rest.
bool rests_at_crowd(std::size_t robot, Vec2 goal, std::span<const CheckedRobot> robots,
                    std::span<const std::optional<Vec2>> places);
/// The same in space, with balls, and with bodies that are longer by their downwash.
bool rests_at_crowd(std::size_t robot, Vec3 goal, std::span<const space::CheckedRobot> robots,
                    std::span<const std::optional<Vec3>> places);

/// m, by robot, of those that rest, of so many.
std::vector<std::optional<Vec3>> places_at_rest(std::size_t robots,
                                                std::span<const space::CheckedState> rows);

}  // namespace avo::judge
