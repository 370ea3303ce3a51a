// SPDX-License-Identifier: Apache-2.0
// Motion of a robot that can accelerate in any direction, Eqs. (7)-(9).
#include "robots/motion.h"

namespace avo {

StepResponse step_response(const Planner& planner) {
  const PlannerOptions& options = planner.options();
  const double rate = planner.step_rate();
  // a step from v to v_1 moves by s v + (Δt - s) v_1, and v_1 = v + rate w
  const double gain = (options.time_step - planner.step_lag()) * rate;
  const bool at_once = adopts_at_once(options.method);
  return {options.time_step, rate, gain, at_once ? options.time_step : options.control_time};
}

MotionStep advance(const MotionState& state, const Plan& plan, const StepResponse& response) {
  const Vec2 w = plan.new_velocity - state.velocity;
  MotionStep step;
  step.next.position = state.position + response.time_step * state.velocity + response.gain * w;
  step.next.velocity = state.velocity + response.rate * w;
  // less than the rounding of its making is rest
  if (norm_squared(step.next.velocity) < 0x1p-100 * norm_squared(state.velocity)) {
    step.next.velocity = {};
  }
  step.acceleration = norm(w) / response.control_time;
  return step;
}

}  // namespace avo
