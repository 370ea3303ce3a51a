// SPDX-License-Identifier: Apache-2.0
// How a decision becomes motion over one time step (paper Eqs. 7-9, 24, 25).
#pragma once
#include "avo/planner.h"
#include "avo/scenario.h"

namespace avo {

struct MotionState {
  Vec2 position;         // m
  Vec2 velocity;         // m/s
  double heading = 0.0;  // rad; of cars
};

struct MotionStep {
  MotionState next;
  double acceleration = 0.0;  // m/s^2, the largest |a| within the step
  // m: at time t of the step it is within bend t²/Δt² of the parabola with the same ends and the
  // same velocity at the start; infinite where that is not known
  double bend = 0.0;
};

/// What one step of a given motion turns w = v' - v into: v + rate w, p + Δt v + gain w.
struct StepResponse {
  Method method;
  double time_step;     // [Δt] s
  double rate;          // of the velocity, see Planner::step_rate()
  double lag;           // s, see Planner::step_lag()
  double gain;          // s, of the position
  double control_time;  // s: |a| = |w| / control_time at the start of the step, its largest value
};
StepResponse step_response(const Planner& planner);

/// A holonomic robot, Eqs. (7)-(9).
MotionStep advance(const MotionState& state, const Plan& plan, const StepResponse& response);

/// A car-like robot, Eqs. (24), (25), integrated exactly along its arc.
struct CarLimits {
  double wheelbase;    // m
  double max_braking;  // m/s^2
  double max_speed;    // m/s
};
MotionStep advance_car(const MotionState& state, const Plan& plan, const CarLimits& limits,
                       double time_step);

}  // namespace avo
