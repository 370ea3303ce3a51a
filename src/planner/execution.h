// SPDX-License-Identifier: Apache-2.0
// How method avo goes towards the v' that it has chosen (docs/smoothness.md): by proportional
// control, Eq. (7), with a time constant of its own, and without jumps of the acceleration.
#pragma once
#include "avo/planner.h"
#include "avo/robot.h"
#include "core/response_law.h"

namespace avo::inline planner {

/// What is common to all robots of a planner.
struct Execution {
  ResponseLaw law;
  double braking_time;    ///< s, see StepLaw
  bool remembers = true;  ///< the robots' last accelerations are known
};
Execution execution_of(const Planner& planner, bool remembers);

/// What one robot makes of it within a step.
struct Haste {
  double gain;  ///< (0, 1], the part of v' - v that is made up for: Δt/T_e
  double most;  ///< m/s, of v_1 - v
  double jerk;  ///< m/s, by which v_1 - v differs from that of the last step; at most kUnlimited
};
Haste haste_of(const Robot& robot, const Execution& execution);
/// To have v' as soon as what is used of a_max lets it.
Haste haste_at_once(const Robot& robot, const Execution& execution);

/// (0, 1], [T_e/T_w]: the part of wish - v that Eq. (23) is asked for where there is no hurry.
double unhurried_part(const Robot& robot, const Execution& execution);

/// [v_1] m/s, from the velocity, and by how much the last step has changed it.
Vec2 executed(Vec2 velocity, Vec2 last_change, Vec2 target, const Haste& haste);

/// Whether the wish is one to have after the step: on the last of the way, where the robot comes to
/// rest.
bool is_landing(const Robot& robot, const Haste& haste, const Execution& execution);

/// For the next step. Whoever overrules a plan has it remembered anew.
void remember(const Plan& plan, Detour& detour);

}  // namespace avo::inline planner
