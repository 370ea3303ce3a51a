// SPDX-License-Identifier: Apache-2.0
// How method avo approaches its chosen v' (docs/smoothness.md): by proportional control, Eq. (7),
// with a time constant of its own, and without jumps of the acceleration.
#pragma once
#include "avo/planner.h"
#include "avo/robot.h"
#include "core/response_law.h"

namespace avo::inline planner {

/// The common values of all robots of a planner.
struct Execution {
  ResponseLaw law;
  double braking_time;    ///< s, see StepLaw
  bool remembers = true;  ///< whether the robots' last accelerations are known
};
Execution execution_of(const Planner& planner, bool remembers);

/// The limits of one robot within a step.
struct Haste {
  double gain;  ///< (0, 1], the part of v' - v that is reached in a step: Δt/T_e
  double most;  ///< m/s, the largest |v_1 - v|
  /// m/s, the largest difference of v_1 - v from that of the last step; at most kUnlimited
  double jerk;
};
Haste haste_of(const Robot& robot, const Execution& execution);
/// Reaches v' as soon as the used part of a_max allows.
Haste haste_at_once(const Robot& robot, const Execution& execution);

/// (0, 1], [T_e/T_w]: the part of wish - v that Eq. (23) is given where there is no hurry.
double unhurried_part(const Robot& robot, const Execution& execution);

/// [v_1] m/s, computed from the velocity, and from the change of velocity in the last step.
Vec2 executed(Vec2 velocity, Vec2 last_change, Vec2 target, const Haste& haste);

/// Returns whether the robot must have the wish after the step: on the last part of the route,
/// where it comes to rest.
bool is_landing(const Robot& robot, const Haste& haste, const Execution& execution);

/// Stores the acceleration for the next step. Code that replaces a plan must call it again.
void remember(const Plan& plan, Detour& detour);

}  // namespace avo::inline planner
