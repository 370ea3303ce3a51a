// SPDX-License-Identifier: Apache-2.0
// The clearance that method avo wishes for beyond contact (docs/scenes.md, "Margin").
#pragma once
#include <algorithm>

#include "avo/planner.h"

namespace avo::inline planner {

inline constexpr double kMarginFades =
    4.0;  // radii, of the goal: none within, all within twice that
inline constexpr double kMarginOfGap = 0.5;  // at most: so each of two comes nearer to the other

inline constexpr double kMoverMargin = 0.5;  // of A's radius: at least, of method avo

/// m: towards one that does not decide.
inline double mover_margin(const PlannerOptions& options, double radius) {
  return options.method == Method::avo ? std::max(options.margin, kMoverMargin * radius) : 0.0;
}

/// m: what is left of the margin so far from the goal.
inline double margin_on_way(double margin, double radius, double distance_to_goal) {
  return margin * std::clamp(distance_to_goal / (kMarginFades * radius) - 1.0, 0.0, 1.0);
}

/// m: what a gap (m, negative in contact) leaves of a margin.
inline double margin_in_gap(double margin, double gap) {
  return std::min(margin, std::max(kMarginOfGap * gap, 0.0));
}

}  // namespace avo::inline planner
