// SPDX-License-Identifier: Apache-2.0
// From two robots to one half-plane (paper §IV-B, §IV-C). Everything is relative to the present
// velocities: w = v'_AB - v_AB, and w = 0 means "both keep their velocity".
#pragma once
#include <algorithm>

#include "avo/export.h"
#include "avo/geometry.h"
#include "avo/horizon.h"
#include "avo/velocity_obstacle.h"

namespace avo {

/// The situation of a pair, which gives its half-plane its meaning.
enum class PairState : unsigned char {
  free,         ///< nothing within reach collides before τ: no half-plane
  constrained,  ///< n . w >= h
  unavoidable,  ///< everything within reach collides: h = reach, the half-plane has one point of it
  overlapping,  ///< in contact already: n . w >= h separates within the shortest window in reach
  coincident,   ///< same center, same velocity: no direction is defined, no half-plane
};

/// The half-plane of a pair, in the relative change w.
struct RelativeHalfPlane {
  PairState state = PairState::free;
  HalfPlane plane;  ///< [n, h] n unit, h in m/s; meaningful where state is not free or coincident
  /// m/s, how much more than reach the line of n asks for; without bound as a closing pair comes
  /// into contact
  double excess = 0.0;
};

/// The half-plane H of Eqs. (15), (16): tangent at the point of the boundary of hull(D(0, reach) ∩
/// AVO) nearest to w = 0. reach = δ (a_A + a_B), m/s. Each property is tested under its number:
/// (1) sound: |w| <= reach and n . w >= h imply |x(t)| >= r_AB on (0, τ];
/// (2) h <= reach; where every reachable w collides h = reach, and excess says by how much more;
/// (3) odd: (-p, -v) gives (-n, h), bit for bit;
/// (4) turning p and v by 90 degrees turns n, bit for bit; mirroring mirrors n, ties apart;
/// (5) ties (p parallel to v) are broken towards the left of p, so that A passes on its right.
AVO_API RelativeHalfPlane half_plane(const Pair& pair, double reach,
                                     const Horizon& horizon) noexcept;

/// ORCA's half-plane: the limit δ -> 0, reach -> infinity, in closed form. time_step is the window
/// in which overlapping robots separate.
AVO_API RelativeHalfPlane orca_half_plane(const Pair& pair, double time_horizon,
                                          double time_step) noexcept;

/// The least share of the responsibility, whatever the priorities; the other robot takes the rest
/// at most. The margin for rounding grows with the inverse of the share
/// (docs/certificate/rounding.md).
inline constexpr double kLeastShare = 1.0 / 64.0;

/// Share of the responsibility of A, Eq. (20): proportional to its ability to change velocity.
/// Where priorities differ, it is proportional to that times its priority, at least kLeastShare and
/// at most the rest. Requires: not both accelerations zero, priorities > 0. (1) 0 <= share <= 1;
/// (2) share(a, b) + share(b, a) = 1 to rounding; (3) equal priorities change no bit.
constexpr double reciprocal_share(double max_acceleration_A, double max_acceleration_B,
                                  double priority_A = 1.0, double priority_B = 1.0) {
  if (priority_A == priority_B)
    return max_acceleration_A / (max_acceleration_A + max_acceleration_B);
  const double a = max_acceleration_A * priority_B, b = max_acceleration_B * priority_A;
  return std::clamp(a / (a + b), kLeastShare, 1.0 - kLeastShare);
}

/// Share of A in the room that is left between both: in a gap, or in a change of velocity that
/// leads to no collision. The robot that has to do less to avoid the other may use more of the
/// room. With equal priorities it is reciprocal_share(). The requirements and (1) to (3) of
/// reciprocal_share() hold.
constexpr double room_share(double max_acceleration_A, double max_acceleration_B,
                            double priority_A = 1.0, double priority_B = 1.0) {
  return reciprocal_share(max_acceleration_A, max_acceleration_B, priority_B, priority_A);
}

/// A's half-plane in v'_A, Eq. (17): the relative half-plane scaled by the share about v_AB, Eq.
/// (2), and moved to v_A, Eq. (3).
constexpr HalfPlane apportion(const HalfPlane& relative, Vec2 v_A, double alpha_AB) {
  return {relative.normal, dot(relative.normal, v_A) + alpha_AB * relative.offset};
}

}  // namespace avo
