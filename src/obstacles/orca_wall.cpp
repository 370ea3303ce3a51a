// SPDX-License-Identifier: Apache-2.0
// ORCA's half-plane of a wall. Its velocity obstacle is a cone cut off by the wall of τ, a convex
// set; one of its edges is nearest. Lemma 14 of docs/half_plane.md.
#include <algorithm>
#include <cmath>
#include <limits>

#include "obstacles/constants.h"
#include "obstacles/wall_pair.h"

namespace avo::inline obstacles {
namespace {

struct Cone {
  const WallPair& pair;
  double time_horizon;  // s
  double tolerance;     // m/s
  HalfPlane least{{}, std::numeric_limits<double>::infinity()};

  // n is a normal of the cone or of its cut: n . p >= r for both ends.
  void offer(Vec2 n, double h) {
    if (h < least.offset - tolerance) least = {n, h};
  }
};

// Offers the flat side that faces the robot.
void offer_flat(Cone& cone) {
  const auto [n, distance] = facing(cone.pair);
  const double r = cone.pair.radius;
  if (distance >= r) cone.offer(n, (r - distance) / cone.time_horizon - dot(n, cone.pair.velocity));
}

// Offers a line from the robot that touches the disc of an end, on its left (1) or on its right
// (-1). The other end must not reach beyond the line.
void offer_leg(Vec2 from_end, Vec2 from_other, double side, Cone& cone) {
  const double r = cone.pair.radius, d2 = norm_squared(from_end);
  const double l = std::sqrt(std::max(0.0, d2 - r * r));
  const Vec2 n = (1.0 / d2) * (r * from_end + (side * l) * perpendicular(from_end));
  if (dot(n, from_other) >= dot(n, from_end)) cone.offer(n, -dot(n, cone.pair.velocity));
}

void offer_tip(Vec2 from_end, Vec2 from_other, Cone& cone) {
  const double r = cone.pair.radius;
  const Vec2 x = from_end + cone.time_horizon * cone.pair.velocity;
  const double length = norm(x);
  if (!(length > 0.0)) return;
  const Vec2 n = x / length;
  if (dot(n, from_end) >= r && dot(n, from_other) >= dot(n, from_end))
    cone.offer(n, (r - length) / cone.time_horizon);
}

}  // namespace

RelativeHalfPlane orca_wall_half_plane(const WallPair& pair, double time_horizon,
                                       double time_step) {
  const Vec2 away = away_from_wall(pair, {}), a = pair.from_a, b = pair.from_b;
  const double r = pair.radius;
  if (!(norm(a - b) > 0.0)) return orca_half_plane({a, pair.velocity, r}, time_horizon, time_step);
  if (norm(away) < r) return orca_half_plane(pair_in_contact(pair, away), time_horizon, time_step);
  Cone cone{pair, time_horizon, kEqualSupports * norm(pair.velocity)};
  offer_flat(cone);
  for (const double side : {1.0, -1.0}) {
    offer_leg(a, b, side, cone);
    offer_leg(b, a, side, cone);
  }
  offer_tip(a, b, cone);
  offer_tip(b, a, cone);
  // none where rounding hides that the robot is on the wall
  if (cone.least.normal == Vec2{})
    return orca_half_plane({away, pair.velocity, r}, time_horizon, time_step);
  return {PairState::constrained, cone.least};
}

}  // namespace avo::inline obstacles
