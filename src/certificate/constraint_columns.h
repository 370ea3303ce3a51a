// SPDX-License-Identifier: Apache-2.0
// Constraints, and a robot's own braking path, in columns: an entry for each constraint or
// interval.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "avo/robot.h"

namespace avo::inline certificate {

/// Columns have room for so many more entries than there are, which are read but do not count.
inline constexpr std::size_t kConstraintLanes = 8;

/// By interval: points of A's braking path, relative to p_A, and how far a candidate's path can get
/// from it at any of the interval's points (docs/certificate/left_out.md).
struct OwnColumns {
  std::size_t count = 0, filled = 0;
  std::vector<double> start_x, start_y, middle_x, middle_y;  ///< m
  std::vector<double> ahead, across, anyhow, most;           ///< m; most: their sum

  /// Room for so many intervals, and where the last of them ends; allocates only while it grows.
  void reserve(std::size_t intervals) {
    if (most.size() >= intervals + 1 + kConstraintLanes) return;  // the last to grow
    for (auto* column :
         {&start_x, &start_y, &middle_x, &middle_y, &ahead, &across, &anyhow, &most}) {
      column->resize(intervals + 1 + kConstraintLanes);
    }
  }
};

/// Of an entry that is no constraint, it only takes up room: what it needs.
inline constexpr double kNoConstraint = std::numeric_limits<double>::infinity();

/// Of constraints that are asked about a candidate: all, or only until one refuses it.
enum class Asked : unsigned char { all, until_refused };

/// See TrajectoryConstraint.
struct ConstraintColumns {
  std::size_t count = 0;
  /// The first so many have a coefficient of the path asked about last; the others have been held
  /// against none, and what stands there is of another path or robot.
  std::size_t judged = 0;
  std::vector<double> normal_x, normal_y, cone, bound;
  std::array<std::vector<double>, 3> offset;
  std::vector<double> interval, needs;  ///< needs: moving > needs, or the constraint is not asked
  std::vector<double> coefficient;      ///< m, of those that are judged
  std::vector<int> neighbor;

  bool is_constraint(std::size_t k) const { return needs[k] < kNoConstraint; }

  void reserve(std::size_t constraints) {
    if (neighbor.size() >= constraints + kConstraintLanes) return;  // the last to grow
    for (auto* column : {&normal_x, &normal_y, &cone, &bound, &offset[0], &offset[1], &offset[2],
                         &interval, &needs, &coefficient}) {
      column->resize(constraints + kConstraintLanes);
    }
    neighbor.resize(constraints + kConstraintLanes);
  }
};

}  // namespace avo::inline certificate
