// SPDX-License-Identifier: Apache-2.0
// Robots with goals that leave no room for all of them, which rest around the place.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/check.h"
#include "avo/space/check.h"

namespace avo::judge {

/// Returns which robots rest around their goals, by robot. Another robot must rest so near the goal
/// that both could not be there. It must be no robot on its route elsewhere: the goals of the two
/// are equally close together, or it has come to its own goal, or rests around that. Robots at rest
/// must lead from one to the other, so close that the robot does not fit through between them.
/// goals: m, of the discs. places: m, of the discs of robots at rest. at_goal: which robots are at
/// their goals.
std::vector<std::uint8_t> rest_at_crowds(std::span<const CheckedRobot> robots,
                                         std::span<const Vec2> goals,
                                         std::span<const std::optional<Vec2>> places,
                                         std::span<const std::uint8_t> at_goal);
/// The same in space, with balls, and with bodies that are longer by their downwash.
std::vector<std::uint8_t> rest_at_crowds(std::span<const space::CheckedRobot> robots,
                                         std::span<const std::optional<Vec3>> places,
                                         std::span<const std::uint8_t> at_goal);

/// m, by robot, of those that rest, of so many.
std::vector<std::optional<Vec3>> places_at_rest(std::size_t robots,
                                                std::span<const space::CheckedState> rows);

}  // namespace avo::judge
