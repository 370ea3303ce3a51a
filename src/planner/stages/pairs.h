// SPDX-License-Identifier: Apache-2.0
// From the sensed states of robots to their pairs, which half-planes are made of.
#pragma once
#include <cstddef>
#include <limits>
#include <vector>

#include "avo/planner.h"
#include "avo/robot.h"
#include "avo/velocity_obstacle.h"
#include "certificate/braking_path.h"
#include "obstacles/half_planes.h"
#include "planner/tile.h"

namespace avo::inline planner {

/// The pair in the form of Eqs. (2), (3): p_AB, v_AB, r_AB.
Pair relative(const Robot& robot, const Neighbor& neighbor);

/// See PlannerOptions::sensing_noise.
Reserve reserve_of(const PlannerOptions& options);

/// The radius of contact with the part of a margin, m, that the gap leaves (docs/scenes.md,
/// "Margin").
double with_margin(const Pair& pair, double margin);

/// The pairs of a tile, robot by robot: the nearest neighbors of each. Allocates only while it
/// grows.
struct TilePairs {
  PairColumns columns;
  std::vector<std::size_t> end;  ///< one past the pairs of each robot
  std::vector<double> share;     ///< of each pair, Eq. (20)
  /// m/s, of each robot: the largest increase of its offsets by movers
  std::vector<double> raise;
};

/// Calls visit(r, k, i) for each pair i of robot r with the neighbor k of tile.neighbors.
template <typename Visit>
void for_each_pair(const Tile& tile, const TilePairs& pairs, const Visit& visit) {
  std::size_t i = 0;
  for (std::size_t r = 0; r < tile.robots.count; ++r)
    for (std::size_t k = tile.robots.neighbors[r].first; i < pairs.end[r]; ++i, ++k) visit(r, k, i);
}

void reserve(std::size_t robots, std::size_t pairs, TilePairs& tile_pairs);

/// Fills in the pairs of the tile. Shares are those of equal priorities. If both have footprints,
/// the two nearest discs count.
void collect_pairs(const PlannerOptions& options, const StepLaw& law, const Tile& tile,
                   TilePairs& pairs);

}  // namespace avo::inline planner
