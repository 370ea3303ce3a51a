// SPDX-License-Identifier: Apache-2.0
// Static obstacles: they do not move, and no robot may touch them. SI units.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/vec.h"

namespace avo {

/// Some of the layers 0 to 31. By layers robots choose the robots that they avoid, and the static
/// obstacles that they heed.
struct LayerSet {
  std::uint32_t bits = 0;  ///< bit k: layer k
  friend constexpr bool operator==(LayerSet, LayerSet) = default;
};
/// Every layer.
inline constexpr LayerSet kAllLayers{0xffffffff};

/// All points within `radius` of the segment from a to b; a disc where a == b.
struct Wall {
  Vec2 a = {};          ///< m
  Vec2 b = {};          ///< m
  double radius = 0.0;  ///< m, >= 0
};

/// Walls from each point to the next one; if `closed`, also from the last point to the first.
struct Chain {
  std::vector<Vec2> points = {};  ///< m, at least one
  bool closed = false;
  friend bool operator==(const Chain&, const Chain&) = default;
};

/// Where a robot may not start even if no wall is near.
enum class Fill : std::uint8_t {
  none,  ///< robots may be on either side of the walls
  /// robots may not be inside the closed chains; the inside of a hole is outside (even-odd rule)
  solid,
  bounds,  ///< robots may not be outside the closed chains (even-odd rule)
};

/// A static obstacle as a scene lists it.
struct StaticObstacle {
  std::vector<Chain> chains = {};  ///< at least one, except for a solid
  double radius = 0.0;  ///< m, >= 0, of all its walls: the radius of a disc, or half of a thickness
  Fill fill = Fill::none;
  /// The exact walls of a map, for an obstacle in which stairs of cells have become straight. They
  /// are behind `chains`: a robot that keeps clear of `chains` does not reach them. Only a judge
  /// reads both.
  std::vector<Chain> measured = {};
  /// Robots that are in one of these layers heed the obstacle. To the other robots it is not there.
  /// All layers: every robot heeds it.
  LayerSet layers = kAllLayers;
  friend bool operator==(const StaticObstacle&, const StaticObstacle&) = default;
};

/// Returns whether a robot in those layers heeds the obstacle.
constexpr bool heeds(LayerSet robot, const StaticObstacle& obstacle) {
  return obstacle.layers == kAllLayers || (robot.bits & obstacle.layers.bits) != 0;
}

/// Returns the walls of all chains, in their order; a chain of one point is a disc.
AVO_API std::vector<Wall> walls_of(std::span<const StaticObstacle> obstacles);
/// The obstacles that a robot in those layers heeds, in their order.
AVO_API std::vector<StaticObstacle> heeded(std::span<const StaticObstacle> obstacles,
                                           LayerSet robot);

}  // namespace avo
