// SPDX-License-Identifier: Apache-2.0
// What each task makes of a team before a step. The members are robots of the simulation.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "avo/teams.h"

namespace avo::inline sim {

void lead(const Queue& queue, Simulation& simulation, Team& team);
void lead(const Follow& follow, Simulation& simulation, Team& team);
void lead(const Patrol& patrol, Simulation& simulation, Team& team);
void lead(const Flow& flow, Simulation& simulation, Team& team);

/// The first robot of a queue goes to its own goal, and leaves the team.
RobotId send_first(Simulation& simulation, Team& team);

/// m: where the member is now.
Vec2 place_of(const Simulation& simulation, const TeamMember& member);
/// Where a polyline is after a length, m; beyond its end it goes straight on. Its points are
/// distinct.
Vec2 place_along(std::span<const Vec2> line, double length);
/// Sorts the members that are not led yet, behind the others, by their distance to the point.
void line_up(const Simulation& simulation, Vec2 point, Team& team);
/// Sets a goal for each member from `first` on.
void set_goals(Simulation& simulation, const Team& team, std::size_t first,
               std::span<const Vec2> goals);

}  // namespace avo::inline sim
