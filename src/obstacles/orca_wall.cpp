// SPDX-License-Identifier: Apache-2.0
// ORCA's half-plane of a wall: its velocity obstacle is a cone cut off by the wall of τ, a convex
// set, of whose edges one is nearest. Lemma 14 of docs/half_plane.md.
#include <array>
#include <cmath>
#include <limits>

#include "obstacles/constants.h"
#include "obstacles/wall_pair.h"

namespace avo {
namespace {

struct Cone {
  const WallPair& pair;
  double time_horizon;  // s
  HalfPlane least{{}, std::numeric_limits<double>::infinity()};

  // n is a normal of the cone or of what cuts it off: n . p >= r for both ends.
  void offer(Vec2 n, double h) {
    if (h < least.offset) least = {n, h};
  }
};

// The legs touch an end's disc, beyond which the other end does not reach.
void offer_legs(Vec2 from_end, Vec2 from_other, Cone& cone) {
  const double r = cone.pair.radius, d2 = norm_squared(from_end);
  const double l = std::sqrt(std::max(0.0, d2 - r * r));
  for (const double side : {1.0, -1.0}) {
    const Vec2 n = (1.0 / d2) * (r * from_end + (side * l) * perpendicular(from_end));
    if (dot(n, from_other) >= dot(n, from_end)) cone.offer(n, -dot(n, cone.pair.velocity));
  }
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

// Where it faces the robot.
void offer_flat(Cone& cone) {
  const auto [n, distance] = facing(cone.pair);
  const double r = cone.pair.radius;
  if (distance >= r) cone.offer(n, (r - distance) / cone.time_horizon - dot(n, cone.pair.velocity));
}

}  // namespace

RelativeHalfPlane orca_wall_half_plane(const WallPair& pair, double time_horizon,
                                       double time_step) {
  const Vec2 away = away_from_wall(pair, {}), v = pair.velocity;
  const double r = pair.radius;
  if (!(norm(pair.from_a - pair.from_b) > 0.0) || norm_squared(away) < r * r)
    return orca_half_plane({away, v, r}, time_horizon, time_step);
  Cone cone{pair, time_horizon};
  for (const auto& [end, other] :
       {std::array{pair.from_a, pair.from_b}, {pair.from_b, pair.from_a}}) {
    offer_legs(end, other, cone);
    offer_tip(end, other, cone);
  }
  offer_flat(cone);
  return {PairState::constrained, cone.least};
}

}  // namespace avo
