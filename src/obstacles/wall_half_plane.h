// SPDX-License-Identifier: Apache-2.0
// The half-plane of a robot and a wall: Eqs. (15), (16) with the obstacle of a whole segment; the
// robot takes the whole share. "Walls" in docs/half_plane.md.
#pragma once
#include "avo/half_plane.h"
#include "avo/robot.h"
#include "avo/wall.h"

namespace avo::inline obstacles {

/// A robot relative to a wall from a to b, as a Pair is relative to a robot.
struct WallPair {
  Vec2 from_a, from_b;  ///< [p - a, p - b] m
  Vec2 velocity;        ///< m/s
  double radius = 0.0;  ///< m, the robot's and the wall's
};

WallPair relative(const Robot& robot, const Wall& wall);

/// Tangent at the point of the boundary of hull(D(0, reach) ∩ AVO) nearest to w = 0. AVO is the
/// union of the obstacles of all points of the wall. reach = δ a_A, m/s. Where a == b it equals
/// half_plane().
/// (1) sound: |w| <= reach and n . w >= h imply a distance of at least r on (0, τ];
/// (2) h <= reach; where every reachable w collides h = reach, and excess says by how much more;
/// (3) ties are broken towards the left of the wall's normal, so that A passes on its right.
RelativeHalfPlane wall_half_plane(const WallPair& pair, double reach, const Horizon& horizon);

/// The limit δ -> 0, reach -> infinity; orca_half_plane() where a == b.
RelativeHalfPlane orca_wall_half_plane(const WallPair& pair, double time_horizon, double time_step);

}  // namespace avo::inline obstacles
