// SPDX-License-Identifier: Apache-2.0
// The preferred velocity of a robot on its way to a goal at which it comes to rest.
#pragma once
#include "avo/planner.h"
#include "sim/fleet.h"

namespace avo {

/// What all robots have in common on their ways.
struct GoalLaw {
  Method method;
  double time_step;     // [Δt] s
  double control_time;  // [δ] s
  double rate;          // see Planner::step_rate()
  double lag;           // s, see Planner::step_lag()
};
GoalLaw goal_law(const Planner& planner);

/// [v_A^pref] m/s: towards the goal at preferred_speed (the paper's), until the distance left is
/// the one that braking needs; then the v' whose next speed is the highest that still stops at the
/// goal. Without other robots it comes to rest on the goal, does not overshoot and does not
/// oscillate, at any δ: v' leads the velocity by the lag of the controller, so near the goal it
/// points away from it.
Vec2 preferred_velocity(Vec2 position, Vec2 velocity, const RobotTraits& robot, Vec2 goal,
                        const GoalLaw& law);

}  // namespace avo
