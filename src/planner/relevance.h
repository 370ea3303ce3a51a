// SPDX-License-Identifier: Apache-2.0
// Whom a decision depends on: of all that a robot senses, only the near ones matter to method avo.
#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include "avo/planner.h"

namespace avo::inline planner {

/// What is known of all robots that one may meet, itself among them.
struct Peers {
  double radius = 0.0;         ///< m, the largest
  double reach = 0.0;          ///< m, the largest of radius and the way of any path that brakes
  double intervals = 0.0;      ///< the most in which one may move until rest
  double most_weakness = 1.0;  ///< max_acceleration by max_braking, 1 at least
  double most_change = 0.0;    ///< m/s^2, see change_limit()
  double least_acceleration = std::numeric_limits<double>::infinity();  ///< m/s^2
  double most_acceleration = 0.0;                                       ///< m/s^2
  double least_priority = std::numeric_limits<double>::infinity();
  double most_priority = 0.0;
};
/// Adds a robot, of which only radius, limits and priority count.
void include(Peers& peers, const Planner& planner, const Robot& robot);

/// A range that grows with the speed that a robot has, see relevant_range().
struct RelevantRange {
  double least = 0.0;             ///< m, whatever the speed
  std::array<double, 3> reach{};  ///< m, s, s²/m: a polynomial of the speed

  [[nodiscard]] double at(double speed) const {
    return std::max(least, reach[0] + speed * (reach[1] + speed * reach[2]));
  }
};

/// m: a neighbor farther away changes no bit of what Planner::plan() decides among neighbors in the
/// order of their distances, unless it is one of the nearest max_neighbors or does not decide
/// itself; 0 where nobody else matters, infinite where all do. Holds while no other robot exceeds
/// its max_speed by more than a rounding, and within kMostRelevantPosition of the origin. Of the
/// robot only radius and limits count.
RelevantRange relevant_range(const Planner& planner, const Robot& robot, const Peers& peers);

/// m, of either coordinate.
inline constexpr double kMostRelevantPosition = 1e6;
/// Part of max_speed that is a rounding.
inline constexpr double kSpeedRounding = 1e-9;

}  // namespace avo::inline planner
