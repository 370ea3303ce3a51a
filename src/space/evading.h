// SPDX-License-Identifier: Apache-2.0
// The inputs of a robot of space that keeps an evasive maneuver: the predicted moving obstacles,
// the boxes that it knows, and its own limits.
#pragma once
#include <optional>
#include <span>

#include "avo/planner.h"
#include "avo/space/mover.h"
#include "planner/rules/levels.h"
#include "space/choice.h"
#include "space/evasions.h"

namespace avo::space {

/// The surroundings of one decision that keeps an evasive maneuver.
struct Sight {
  std::span<const Mover> movers;
  std::span<const Box> boxes;
  bool may_swerve = false;  ///< no other robot is within sight, and the options allow it
};

/// The state of one decision.
struct Evading {
  const StepLaw& law;
  const Robot& robot;
  const Sight& sight;
  EvasionSearch& search;
  ChoiceWorkspace& workspace;
  double braking = 0.0;  // s, the longest time of braking
};

/// None for robots that have no evasive maneuvers, since they brake for too long.
std::optional<Evading> begin_evading(const PlannerOptions& options, const StepLaw& law,
                                     const Robot& robot, const Sight& sight, EvasionSearch& search,
                                     ChoiceWorkspace& workspace);
/// Predicts all moving obstacles, and begins evasive maneuvers of that level.
void look_around(Evading& evading, const Level& level);

}  // namespace avo::space
