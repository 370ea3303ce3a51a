// SPDX-License-Identifier: Apache-2.0
// A pair of space in a plane: its half-space is the half-plane of the paper in the plane of p and
// v. See docs/space.md, "The half-space of a pair".
#pragma once
#include "avo/vec.h"
#include "avo/vec3.h"

namespace avo::space {

/// An orthonormal frame of a plane that contains p = p_A - p_B, m, and v = v_A - v_B, m/s.
/// Exchanging the robots negates both axes and changes no other bit.
struct PairFrame {
  double distance;  ///< |p|, m, > 0
  Vec3 along;       ///< p/|p|
  Vec3 across;      ///< on v's side; where v is parallel to p, the side on which both pass
  Vec2 velocity;    ///< m/s, of v along these axes; velocity.y >= 0
};

/// Requires p != 0. Where p and v are parallel, `across` points to the left of p in the horizontal
/// plane, so that each robot passes on its right. Where p is vertical as well, it is the side of +y
/// for the upper robot.
PairFrame frame_of(Vec3 p, Vec3 v);

/// The vector of space.
inline Vec3 turned_back(const PairFrame& frame, Vec2 a) {
  return a.x * frame.along + a.y * frame.across;
}

}  // namespace avo::space
