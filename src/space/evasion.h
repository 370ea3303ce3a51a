// SPDX-License-Identifier: Apache-2.0
// Beside moving obstacles, a robot of space keeps an evasive maneuver: docs/movers.md, with 26
// directions.
#pragma once
#include "space/evading.h"

namespace avo::space {

/// Replaces the choice by the nearest first step of an evasive maneuver, where the choice leaves
/// none and there is one. choice_workspace: after begin_constraints(). Returns whether it has
/// replaced it.
bool keep_evasion(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                  const Sight& sight, EvasionSearch& search, ChoiceWorkspace& choice_workspace,
                  Vec3& next_velocity);

}  // namespace avo::space
