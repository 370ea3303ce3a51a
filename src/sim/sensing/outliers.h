// SPDX-License-Identifier: Apache-2.0
// Robots that differ from most of their fleet. Only robots near one of them examine others more
// closely, or farther away, for its sake.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "avo/vec.h"
#include "spatial/point_grid.h"

namespace avo::inline sim {

struct World;

/// How a robot examines the robots that the search has found.
enum class Scrutiny : std::uint8_t {
  plain,       ///< all have the usual Conduct, and brake with max_acceleration
  one_by_one,  ///< some differ, but all decide
  everyone,    ///< it does not avoid some, or some do not decide: all sensed robots must be found
};

struct Outlier {
  int rank = 0;
  bool reaches_far = false;  // it matters to others from much farther away than most robots do
  bool is_unlike = false;    // in priority, braking or footprint
  // it is parked or loiters, or some robot does not avoid it, or it does not avoid some robot
  bool stands_apart = false;
};

struct Outliers {
  Scrutiny usual = Scrutiny::plain;  // of robots that are near no outlier
  std::vector<Outlier> robots;  // by ascending rank; empty where there are too many to distinguish
  double reach = 0.0;  // m: beyond it they do not matter to others, except by standing apart
  // at the beginning of the step
  std::vector<Vec2> position, velocity;  // m, m/s
  PointGrid grid;                        // holds their indices
  // by key of a cell: whether an outlier, or a moving obstacle, may be sensed there; empty: nowhere
  std::vector<std::uint8_t> in_sight;

  bool may_be_sensed(std::uint32_t cell) const { return !in_sight.empty() && in_sight[cell] != 0; }
};

/// Finds the outliers, and the ranges of the fleet: how far each robot has to search, as long as no
/// robot is fast.
void find_ranges(World& world);

/// Finds the places of the outliers, and the cells in which an outlier or a moving obstacle may be
/// sensed.
void locate_outliers(World& world);

}  // namespace avo::inline sim
