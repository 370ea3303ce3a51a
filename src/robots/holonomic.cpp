// SPDX-License-Identifier: Apache-2.0
// Motion of a robot that can accelerate in any direction, Eqs. (7)-(9).
#include "core/scalar.h"
#include "robots/holonomic_kernel.h"
#include "robots/motion.h"

namespace avo::inline robots {
StepResponse step_response(const Planner& planner) {
  const PlannerOptions& options = planner.options();
  const double rate = planner.step_rate(), lag = planner.step_lag();
  // a step from v to v_1 moves by s v + (Δt - s) v_1, and v_1 = v + rate w
  const double gain = (options.time_step - lag) * rate;
  const bool at_once = adopts_at_once(options.method);
  return {.method = options.method,
          .time_step = options.time_step,
          .rate = rate,
          .lag = lag,
          .gain = gain,
          .control_time = at_once ? options.time_step : options.control_time,
          .law = response_law(options)};
}

MotionStep advance(const MotionState& state, const Plan& plan, const StepResponse& response) {
  using Real = scalar::Pack<double>;
  const auto in_lane = [](Vec2 a) { return scalar::constant<Real>(a); };
  const scalar::Moved<Real> next = scalar::moved(in_lane(state.position), in_lane(state.velocity),
                                                 in_lane(plan.new_velocity), response);
  MotionStep step;
  step.next.position = plain(next.position);
  step.next.velocity = plain(next.velocity);
  step.acceleration = next.acceleration.value;
  return step;
}

}  // namespace avo::inline robots
