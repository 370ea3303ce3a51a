// SPDX-License-Identifier: Apache-2.0
// Arriving: keep right in traffic, give way, back out of a jam (docs/arrival.md). All of it only
// turns the preferred velocity, so that safety never depends on it; local, deterministic, the same
// for every robot.
#pragma once
#include "avo/planner.h"
#include "core/neighbor_columns.h"
#include "planner/traffic.h"

namespace avo {

/// m, as far as the two rules below look at any neighbor of at most that radius.
double arrival_range(const Robot& robot, double largest_radius);

Traffic look_around(const Robot& robot, const Neighbors& neighbors);

/// The preferred velocity turned to the right by how congested the way ahead is; as it is on the
/// last of the way to the goal.
Vec2 keep_right(const Robot& robot, const Traffic& traffic);

/// Away from a neighbor that is nearly in contact, most of all where the robot has all but arrived.
Vec2 push_of(const Robot& robot, const Neighbor& neighbor);

/// [m/s] to add to the wish. It gives way for a while: who stays beside it has come to rest as
/// well.
Vec2 give_way(const Robot& robot, const Traffic& traffic, double time_step, Detour& detour);

/// Whether it is something that a robot can remember.
bool is_sound(const Detour& detour);

/// Whether the robot has been beside others for so long, and so near its goal, that it stays there.
bool has_settled(const Robot& robot, const Detour& detour);

/// a turned clockwise by an angle in [0, π) rad, nearly; its length is kept.
Vec2 turned_right(Vec2 a, double angle);

/// Whether less than half is left of the velocity along `wish` that the limits alone allow.
bool is_blocked(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 wish);

/// Whether the robot may leave its way at all: not where it has all but arrived.
bool may_detour(const Robot& robot);

/// Turns off further while the detour is blocked as well, and back once the way is free.
void turn_off(Detour& detour, const Robot& robot, double time_step);
void turn_back(Detour& detour, const Robot& robot, double time_step);

}  // namespace avo
