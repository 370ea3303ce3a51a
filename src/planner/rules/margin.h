// SPDX-License-Identifier: Apache-2.0
// The clearance that method avo prefers beyond contact (docs/scenes.md, "Margin").
#pragma once
#include <algorithm>

#include "avo/planner.h"

namespace avo::inline planner {

inline constexpr double kMarginFades =
    4.0;  // radii from the goal: no margin within, the full margin beyond twice that
// at most this part, so that each of two robots may come nearer to the other
inline constexpr double kMarginOfGap = 0.5;

inline constexpr double kMoverMargin = 0.5;  // of A's radius: the least margin of method avo

/// m: the margin towards a neighbor that does not decide.
inline double mover_margin(const PlannerOptions& options, double radius) {
  return method_traits(options.method).has_rules ? std::max(options.margin, kMoverMargin * radius)
                                                 : 0.0;
}

/// m: the remaining margin at that distance from the goal.
inline double margin_on_route(double margin, double radius, double distance_to_goal) {
  return margin * std::clamp(distance_to_goal / (kMarginFades * radius) - 1.0, 0.0, 1.0);
}

/// m: the part of a margin that a gap (m, negative in contact) leaves.
inline double margin_in_gap(double margin, double gap) {
  return std::min(margin, std::max(kMarginOfGap * gap, 0.0));
}

}  // namespace avo::inline planner
