// SPDX-License-Identifier: Apache-2.0
// The three obstacles of the paper as sets: membership, discs, tangents, boundary. This is the
// readable reference for tests, plots and research; the planner uses half_plane.h.
#pragma once
#include <utility>
#include <vector>

#include "avo/export.h"
#include "avo/geometry.h"
#include "avo/response.h"

namespace avo {

/// Robot A relative to B: p_AB = p_A - p_B (m), v_AB = v_A - v_B (m/s), r_AB = r_A + r_B (m).
struct Pair {
  Vec2 position = {};
  Vec2 velocity = {};
  double radius = 0.0;
};

/// Pair under a response g: the relative position is x(t) = p + t v + g(t) w for 0 < t < horizon.
///   velocity obstacle, Eqs. (4)-(6)                 g = t,                     set of u = v + w
///   acceleration obstacle, §III-B                   g = t^2 / 2,               set of u = w
///   acceleration-velocity obstacle, Eqs. (10)-(12)  g = t + δ (e^{-t/δ} - 1),  set of u = v + w
/// All functions below speak of u: a new relative velocity (m/s), or for the acceleration
/// obstacle a relative acceleration (m/s^2).
struct Obstacle {
  Pair pair;
  Response response;
  double time_horizon = 0.0;  ///< [τ] s
};

/// How near two robots come, and when.
struct ClosestApproach {
  double time = 0.0;      ///< s, the earliest time of the smallest distance in [0, time_horizon]
  double distance = 0.0;  ///< m, between the centers
};

/// w, the change that u stands for: u - v, or u itself for the acceleration obstacle.
AVO_API Vec2 change(const Obstacle& obstacle, Vec2 u);

/// Relative position at time t under u, Eq. (9).
AVO_API Vec2 relative_position(const Obstacle& obstacle, Vec2 u, double t);

/// Smallest distance of the centers over the window, exact to rounding (branch and bound on t).
AVO_API ClosestApproach closest_approach(const Obstacle& obstacle, Vec2 u);

/// Returns whether u is forbidden: a distance below r_AB somewhere in the window, Eqs. (4), (10).
AVO_API bool contains(const Obstacle& obstacle, Vec2 u);

/// The disc of all u that collide at time t > 0, Eqs. (5), (11), (27), (28).
AVO_API Disc disc(const Obstacle& obstacle, double t);

/// Points where the two tangents from the origin touch `disc`, left q- then right q+, Eq. (26). No
/// tangent exists if the origin is inside the disc: both points are then its center.
AVO_API std::pair<Vec2, Vec2> tangent_points(const Disc& disc);

/// Times are left out if their disc lies inside the discs just before: they add no boundary.
struct Boundary {
  std::vector<Vec2> left;   ///< b-(t), from time_horizon back to the earliest time
  std::vector<Vec2> right;  ///< b+(t), at the same times
  std::vector<Vec2> cap;    ///< arc of the last disc from left.front() to right.front(), if exposed
};

/// `samples` points along each side, Eq. (29), at uniform times in (0, time_horizon].
AVO_API Boundary boundary(const Obstacle& obstacle, int samples);

}  // namespace avo
