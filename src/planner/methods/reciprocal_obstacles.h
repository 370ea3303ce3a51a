// SPDX-License-Identifier: Apache-2.0
// Method reciprocal_velocity_obstacle: J. van den Berg, M. Lin, D. Manocha, "Reciprocal Velocity
// Obstacles for Real-Time Multi-Agent Navigation", ICRA 2008.
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/robot.h"
#include "planner/methods/passive_obstacles.h"

namespace avo::inline planner {

/// [w] m: the cost of a time to collision of 1 s, against 1 m/s of distance to the preferred
/// velocity. The paper leaves it open; this value is that of the examples of its authors' library.
inline constexpr double kSafetyFactor = 7.5;

/// RVO(v_B, v_A, α) = { v' | v'/α + (1 - 1/α) v_A in VO(v_B) }, §V-A of that paper: the velocity
/// obstacle with its apex at (1 - α) v_A + α v_B and α times as large. The share α is that of Eq.
/// (20), 1/2 between equals. It is 1 against a mover, where this is the velocity obstacle.
PassiveObstacle reciprocal_obstacle(const PlannerOptions& options, const Robot& robot,
                                    const Neighbor& neighbor);

/// s, until they touch at the new velocity v_new, with the motion of the other that the obstacle
/// assumes. It is infinite where they do not touch within the horizon, and where they are in
/// contact already.
double time_to_collision(const PassiveObstacle& obstacle, double time_horizon, Vec2 v_new);

/// Where no velocity is free: the least w/tc + |v_pref - v'| (the paper's penalty), with tc the
/// first time to collision with any obstacle. The candidates are those that
/// choose_among_movers() has left in `workspace`. The paper draws them at random. Lines, of
/// walls and of pairs in contact, come first: they are violated as little as possible. The
/// violation is that of choose_among_movers().
PassiveChoice least_penalty(std::span<const PassiveObstacle> obstacles, const Disc& speed,
                            double time_horizon, Vec2 preferred, const PassiveWorkspace& workspace);

}  // namespace avo::inline planner
