// SPDX-License-Identifier: Apache-2.0
// How a decision becomes motion over one time step (paper Eqs. 7-9, 24, 25).
#pragma once
#include <cstdint>

#include "avo/planner.h"
#include "avo/scenario.h"
#include "core/response_law.h"

namespace avo::inline robots {

/// rad, the largest turn of a car or an airplane in a step. It is less than half a turn, so that
/// the headings at the ends of a step determine the arc between them.
inline constexpr double kMostTurn = 3.0;

struct MotionState {
  Vec2 position;             // m, of its disc
  Vec2 velocity;             // m/s
  double heading = 0.0;      // rad; not of holonomic robots
  LoiterCircle circle = {};  // for an airplane: its fallback
};

struct MotionStep {
  MotionState next;
  double acceleration = 0.0;  // m/s^2, the largest |a| within the step
  // m: at time t of the step the disc is within bend t²/Δt² of a parabola. This has the same ends,
  // and the start velocity state.velocity + swing. Infinite where that is not known
  double bend = 0.0;
  Vec2 swing = {};  // m/s, of a disc ahead of the axle that the robot turns about
  double length =
      0.0;  // m, an upper bound of the length of the disc's path; not for holonomic robots
};

/// The effect of one step on w = v' - v: v + rate w, p + Δt v + gain w.
struct StepResponse {
  Method method;
  double time_step;     // [Δt] s
  double rate;          // of the velocity, see Planner::step_rate()
  double lag;           // s, see Planner::step_lag()
  double gain;          // s, of the position
  double control_time;  // s: |a| = |w| / control_time at the start of the step, its largest value
  ResponseLaw law;      // how gently v' is approached
};
StepResponse step_response(const Planner& planner);

/// A holonomic robot, Eqs. (7)-(9).
MotionStep advance(const MotionState& state, const Plan& plan, const StepResponse& response);

/// The state of a holonomic robot `time` s after the start of a step of `duration` s, 0 <= time <
/// duration. at_once: it has had the end velocity from the start.
MotionState within(const MotionState& from, const MotionState& to, bool at_once, double time,
                   double duration);

}  // namespace avo::inline robots
