// SPDX-License-Identifier: Apache-2.0
// Beside moving obstacles, a robot of space keeps an evasive maneuver: docs/movers.md, with 26
// directions.
#pragma once
#include "space/evading.h"

namespace avo::space {

/// Replaces the choice by the nearest first step of an evasive maneuver, where the choice leaves
/// none and there is one. choice_workspace: after begin_constraints(). Returns whether it has
/// replaced it. The search then knows the evasive maneuver and the rejected choice.
bool keep_evasion(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                  const Sight& sight, EvasionSearch& search, ChoiceWorkspace& choice_workspace,
                  Vec3& next_velocity);

/// The moving obstacle that the robot evades, if it has rejected a next velocity, m/s. It is the
/// index of the nearest one that comes too near if the robot brakes after that step; -1: none.
int find_evaded(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                std::span<const Mover> movers, Vec3 put_aside, EvasionSearch& search,
                ChoiceWorkspace& choice_workspace);

}  // namespace avo::space
