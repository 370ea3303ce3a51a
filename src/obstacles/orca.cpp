// SPDX-License-Identifier: Apache-2.0
// ORCA: the velocity obstacle of Eqs. (4)-(6) is a truncated cone, and H its tangent nearest to
// the present relative velocity. The limit δ -> 0, reach -> infinity of half_plane().
#include <cmath>

#include "avo/half_plane.h"
#include "obstacles/constants.h"

namespace avo {
namespace {

// The side of p on which v is counted: 1 left, -1 right. Parallel vectors are a tie, which goes to
// the left of p: A passes B on its own right. A tie must survive rounding: it is |sin| <= kTie.
double side_of(Vec2 p, Vec2 v, double length_p, double length_v) {
  return cross(p, v) < -kTie * length_p * length_v ? -1.0 : 1.0;
}

// Boundary of the disc of one time: n = (p + t v)/|p + t v|.
RelativeHalfPlane disc_plane(const Pair& pair, double t, PairState state) {
  Vec2 x = pair.position + t * pair.velocity;
  double length = norm(x);
  const double h = (pair.radius - length) / t;
  if (!(length > 0.0)) {  // centers meet at t: along p, or along v where p is 0
    x = pair.position == Vec2{} ? pair.velocity : pair.position;
    length = norm(x);
    if (!(length > 0.0)) return {PairState::coincident, {}};
  }
  return {state, {x / length, h}};
}

}  // namespace

RelativeHalfPlane orca_half_plane(const Pair& pair, double time_horizon,
                                  double time_step) noexcept {
  const Vec2 p = pair.position, v = pair.velocity;
  const double r = pair.radius;
  const double d2 = norm_squared(p);
  if (d2 < r * r || !(d2 > 0.0)) return disc_plane(pair, time_step, PairState::overlapping);

  const Vec2 x = p + time_horizon * v;
  if (dot(x, p) >= r * norm(x) && norm_squared(x) > 0.0) {
    return disc_plane(pair, time_horizon, PairState::constrained);
  }
  // a leg of the cone: n . p = r, on the side of v; the left of p where they are parallel
  const double l = std::sqrt(d2 - r * r) * side_of(p, v, std::sqrt(d2), norm(v));
  const Vec2 n = (r * p + l * perpendicular(p)) / d2;
  return {PairState::constrained, {n, -dot(n, v)}};
}

}  // namespace avo
