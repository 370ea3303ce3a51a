// SPDX-License-Identifier: Apache-2.0
// Arriving: keep right in traffic, back out of a jam. Both only turn the preferred velocity, so that
// safety never depends on them; local, deterministic, the same for every robot.
#pragma once
#include <span>

#include "avo/planner.h"

namespace avo {

/// The preferred velocity turned to the right by how congested the way ahead is.
Vec2 keep_right(const Robot& robot, std::span<const Neighbor> neighbors);

/// a turned clockwise, by an angle in [0, π); exact rotation by nearly that angle.
Vec2 turned_right(Vec2 a, double angle);

/// Whether of the velocity along `preferred` that the limits alone allow, less than half is left.
bool is_blocked(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 preferred);

}  // namespace avo
