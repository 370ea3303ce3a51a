// SPDX-License-Identifier: Apache-2.0
// The neighbors on which a decision depends: of all neighbors that a robot senses, only the near
// ones matter to method avo.
#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include "avo/planner.h"

namespace avo::inline planner {

/// The known bounds of all robots that a robot may meet, with itself.
struct Peers {
  double radius = 0.0;  ///< m, the largest
  double reach = 0.0;   ///< m, the largest of the radii and the distances of braking paths
  /// the largest number of intervals in which a robot may move until rest
  double intervals = 0.0;
  double most_weakness = 1.0;  ///< max_acceleration divided by max_braking, at least 1
  double most_change = 0.0;    ///< m/s^2, see change_limit()
  double least_acceleration = std::numeric_limits<double>::infinity();  ///< m/s^2
  double most_acceleration = 0.0;                                       ///< m/s^2
  double least_priority = std::numeric_limits<double>::infinity();
  double most_priority = 0.0;
};
/// Adds a robot; only its radius, limits and priority count.
void include(Peers& peers, const Planner& planner, const Robot& robot);

/// A range that grows with the speed of the robot, see relevant_range(). Each robot keeps one,
/// so its numbers are narrow, and rounded up.
struct RelevantRange {
  float least = 0.0F;            ///< m, whatever the speed
  std::array<float, 3> reach{};  ///< m, s, s²/m: a polynomial of the speed

  [[nodiscard]] double at(double speed) const {
    const double curved = double{reach[1]} + speed * double{reach[2]};
    return std::max(double{least}, double{reach[0]} + speed * curved);
  }
};

/// m: a neighbor farther away changes no bit of the decision of Planner::plan() among neighbors in
/// the order of their distances. Exceptions are the nearest max_neighbors, and neighbors that do
/// not decide. The range is 0 where no neighbor matters, infinite where all do. It holds while no
/// other robot exceeds its max_speed by more than a rounding, and within kMostRelevantPosition of
/// the origin. Only radius and limits of the robot count.
RelevantRange relevant_range(const Planner& planner, const Robot& robot, const Peers& peers);

/// m, of either coordinate.
inline constexpr double kMostRelevantPosition = 1e6;
/// The part of max_speed that counts as rounding.
inline constexpr double kSpeedRounding = 1e-9;

}  // namespace avo::inline planner
