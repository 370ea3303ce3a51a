// SPDX-License-Identifier: Apache-2.0
// How a robot that keeps its velocity passes a wall.
#pragma once
#include <array>

#include "obstacles/wall_half_plane.h"

namespace avo::inline obstacles {

/// [p - q] m for both ends q.
inline std::array<Vec2, 2> ends_of(const WallPair& pair) {
  return {pair.from_a, pair.from_b};
}

/// m, from the nearest point of the wall to the robot's place after that displacement.
Vec2 away_from_wall(const WallPair& pair, Vec2 moved);

/// m, from the nearest point of the wall to that of the ray on which the robot keeps its velocity;
/// 0 where the ray crosses the wall.
Vec2 nearest_pass(const WallPair& pair);

/// The unit normal of the wall's line towards the robot, and the robot's distance from the line.
struct Facing {
  Vec2 normal;
  double distance = 0.0;  // m, >= 0
};
Facing facing(const WallPair& pair);

/// The pair that separates the two where they overlap: away from the wall's nearest point. Where
/// the robot's center is on the wall, it is across the wall to the side that the robot moves to.
Pair pair_in_contact(const WallPair& pair, Vec2 away);

}  // namespace avo::inline obstacles
