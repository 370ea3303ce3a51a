// SPDX-License-Identifier: Apache-2.0
// Robots that are unlike most of their fleet. Only who is near one of them looks at others more
// closely for its sake, or farther.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "avo/vec.h"
#include "neighbors/uniform_grid.h"

namespace avo::inline sim {

struct World;

/// How a robot looks at those that the search has found.
enum class Scrutiny : std::uint8_t {
  plain,       ///< all are of the usual Conduct, and brake as hard as they can
  one_by_one,  ///< some are not, but all decide
  everyone,    ///< it does not mind some, or some do not decide: whoever is sensed has to be found
};

struct Outlier {
  int rank = 0;
  bool reaches_far = false;   // to others it matters from much farther away than most do
  bool is_unlike = false;     // in priority or braking
  bool stands_apart = false;  // it is parked or loiters, or not all mind it, or it not all
};

struct Outliers {
  Scrutiny usual = Scrutiny::plain;  // of those who are near no outlier
  std::vector<Outlier> robots;  // by ascending rank; empty where there are too many to tell apart
  double reach = 0.0;  // m: to others they do not matter, but for standing apart, beyond it
  // at the beginning of the step
  std::vector<Vec2> position, velocity;  // m, m/s
  UniformGrid grid;                      // called by their index
  std::vector<std::uint8_t> in_sight;    // by key of a cell: whether one of them, or a moving
                                         // obstacle, may be sensed there; empty: nowhere

  bool may_be_sensed(std::uint32_t cell) const { return !in_sight.empty() && in_sight[cell] != 0; }
};

/// Finds them, and the ranges of the fleet: how far each robot has to look, as long as none is
/// fast.
void find_ranges(World& world);

/// Where they are, and who may sense them or a moving obstacle.
void locate_outliers(World& world);

}  // namespace avo::inline sim
