// SPDX-License-Identifier: Apache-2.0
// When goals leave no room for two robots (docs/arrival.md, rule 4).
#pragma once
#include <cstddef>

#include "avo/vec.h"
#include "sim/columns/fleet.h"

namespace avo::inline sim {

/// Returns whether the robot moves to its goal and comes to rest there.
bool rests_at_goal(const Fleet& fleet, std::size_t slot);
/// Returns whether two such robots may not be in one place.
bool keep_apart(const Conduct& a, const Conduct& b);
/// Returns whether there is no room for two robots at these places, m, with these route radii, m.
bool leave_no_room(Vec2 a, double radius_a, Vec2 b, double radius_b);

}  // namespace avo::inline sim
