// SPDX-License-Identifier: Apache-2.0
// Constraints, and a robot's own braking path, in columns: one entry for each constraint or
// interval.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "avo/robot.h"

namespace avo::inline certificate {

/// The columns have room for so many extra entries, which are read but do not count.
inline constexpr std::size_t kConstraintLanes = 8;

/// By interval: points of A's braking path, relative to p_A, and the largest distance of a
/// candidate's path from it at any of the interval's points (docs/certificate/left_out.md).
template <int D>
struct OwnColumnsOf {
  std::size_t count = 0, filled = 0;
  std::array<std::vector<double>, D> start, middle;  ///< m, by axis
  std::vector<double> ahead, across, anyhow, most;   ///< m; most: the sum of the others

  /// Reserves room for so many intervals, and for the end of the last one; allocates only while it
  /// grows.
  void reserve(std::size_t intervals) {
    if (most.size() >= intervals + 1 + kConstraintLanes) return;  // this column grows last
    const std::size_t size = intervals + 1 + kConstraintLanes;
    for (auto* vectors : {&start, &middle}) {
      for (auto& column : *vectors) column.resize(size);
    }
    for (auto* column : {&ahead, &across, &anyhow, &most}) {
      column->resize(size);
    }
  }
};
using OwnColumns = OwnColumnsOf<2>;

/// The `needs` of an entry that is no constraint and only fills a lane.
inline constexpr double kNoConstraint = std::numeric_limits<double>::infinity();

/// Which constraints are tested for a candidate: all, or only until one refuses it.
enum class Asked : unsigned char { all, until_refused };

/// See TrajectoryConstraint.
template <int D>
struct ConstraintColumnsOf {
  std::size_t count = 0;
  /// The first so many have a coefficient for the last tested path. The others have not been
  /// tested: their values are of another path or robot.
  std::size_t tested = 0;
  std::array<std::vector<double>, D> normal;  ///< by axis
  std::vector<double> cone, bound;
  std::array<std::vector<double>, 3> offset;
  std::vector<double> interval, needs;  ///< needs: the constraint applies only if moving > needs
  std::vector<double> coefficient;      ///< m, of the tested constraints
  std::vector<int> neighbor;

  bool is_constraint(std::size_t k) const { return needs[k] < kNoConstraint; }

  void reserve(std::size_t constraints) {
    if (neighbor.size() >= constraints + kConstraintLanes) return;  // this column grows last
    for (auto& column : normal) column.resize(constraints + kConstraintLanes);
    for (auto* column :
         {&cone, &bound, &offset[0], &offset[1], &offset[2], &interval, &needs, &coefficient}) {
      column->resize(constraints + kConstraintLanes);
    }
    neighbor.resize(constraints + kConstraintLanes);
  }
};
using ConstraintColumns = ConstraintColumnsOf<2>;

}  // namespace avo::inline certificate
