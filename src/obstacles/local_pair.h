// SPDX-License-Identifier: Apache-2.0
// A pair in its own frame, in which the half-plane of Eqs. (15), (16) is found.
#pragma once
#include <cmath>

#include "avo/half_plane.h"

namespace avo {

/// The side of p on which v is counted: 1 left, -1 right. Parallel vectors are a tie, which goes to
/// the left of p: A passes B on its own right. A tie has to survive rounding, or robots on a circle
/// would each choose a side at random: it is |sin| <= 1e-9.
inline double side_of(Vec2 p, Vec2 v, double length_p, double length_v) {
  return cross(p, v) < -1e-9 * length_p * length_v ? -1.0 : 1.0;
}

/// First axis along p, second across it on v's side: p = (d, 0), v.y >= 0 but for ties. Exchanging
/// the robots turns this frame by 180 degrees and changes no number in it: all that is computed
/// here is odd in (p, v) and turns with the plane by 90 degrees, bit for bit.
///
/// In w = v' - v the obstacle is the family of discs {w : |x(t) + g(t) w| < r}. Their envelope has
/// at time t the normals n with n . y(t) = r.
struct LocalPair {
  double d;  // |p|, m
  Vec2 v;    // m/s
  double r;  // m
  double R;  // reach, m/s

  Vec2 x(const ResponseAt& at) const { return {d + at.time * v.x, at.time * v.y}; }  // p + t v
  Vec2 y(const ResponseAt& at) const { return {d + at.lag * v.x, at.lag * v.y}; }    // p + s v
};

struct LocalPlane {
  bool free = false;  // the obstacle is out of reach
  Vec2 n;
  double h = 0.0;
};

/// The horn case: v does not lead into a collision (p . v >= 0 or a miss distance >= r, and
/// d >= r), and the disc of τ alone is not nearest.
LocalPlane horn_half_plane(const LocalPair& pair, const Horizon& horizon);

/// half_plane() of a pair in the horn case that no kernel settles.
RelativeHalfPlane searched_half_plane(const Pair& pair, double reach,
                                      const Horizon& horizon) noexcept;

}  // namespace avo
