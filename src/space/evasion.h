// SPDX-License-Identifier: Apache-2.0
// Beside moving obstacles, a robot of space keeps a way out: docs/movers.md, with 26 directions.
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/space/box.h"
#include "avo/space/mover.h"
#include "avo/space/robot.h"
#include "space/choice.h"
#include "space/ways.h"

namespace avo::space {

/// The surroundings of one decision that keeps a way out.
struct Sight {
  std::span<const Mover> movers;
  std::span<const Box> boxes;
  bool may_swerve = false;  ///< no other robot is within sight, and the options allow it
};

/// Replaces the choice by the nearest first step of a way out, where the choice leaves none and
/// there is one. choice_workspace: after begin_constraints(). Returns whether it has replaced it.
bool keep_a_way_out(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                    const Sight& sight, WaySearch& search, ChoiceWorkspace& choice_workspace,
                    Vec3& next_velocity);

}  // namespace avo::space
