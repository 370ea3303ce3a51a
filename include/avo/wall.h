// SPDX-License-Identifier: Apache-2.0
// Static obstacles: what does not move, and nobody may touch. SI units.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/vec.h"

namespace avo {

/// All that is within `radius` of the segment from a to b; a disc where a == b.
struct Wall {
  Vec2 a = {};          ///< m
  Vec2 b = {};          ///< m
  double radius = 0.0;  ///< m, >= 0
};

/// Walls from each point to the next one, and from the last one to the first where it is closed.
struct Chain {
  std::vector<Vec2> points = {};  ///< m, at least one
  bool closed = false;
  friend bool operator==(const Chain&, const Chain&) = default;
};

/// Where a robot may not start, though no wall is near.
enum class Fill : std::uint8_t {
  none,    ///< robots may be on either side of the walls
  solid,   ///< not inside the closed chains; inside of a hole is outside (even-odd rule)
  bounds,  ///< not outside of them, likewise
};

/// A static obstacle as a scene lists it.
struct StaticObstacle {
  std::vector<Chain> chains = {};  ///< at least one, but of a solid
  double radius = 0.0;  ///< m, >= 0, of all its walls: that of a disc, or half of a thickness
  Fill fill = Fill::none;
  /// Of a map whose stairs of cells have become straight, its own walls: behind `chains`, where
  /// nobody gets who keeps clear of these. A judge looks at both, and nobody else looks at them.
  std::vector<Chain> measured = {};
  friend bool operator==(const StaticObstacle&, const StaticObstacle&) = default;
};

/// The walls of all chains, in their order; a chain of one point is a disc.
AVO_API std::vector<Wall> walls_of(std::span<const StaticObstacle> obstacles);

}  // namespace avo
