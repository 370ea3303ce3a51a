// SPDX-License-Identifier: Apache-2.0
// The reference of a base that does not execute exactly, and the commands that keep the base near
// it (docs/certificate/execution.md, "The commands").
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "avo/error.h"
#include "avo/execution.h"
#include "robots/execution_bounds.h"
#include "robots/model.h"
#include "robots/motion.h"

namespace avo {

struct ReferenceTracker::State {
  ExecutionModel model;
  StepResponse response;
  ExecutionLimits limits = {};                // the largest so far
  std::optional<MotionState> reference = {};  // at the beginning of this step
  std::vector<Vec2> sent = {};                // m/s, of the last steps, cyclically
  std::size_t next = 0;                       // place of the next command in it
  bool has_sent = false;
};

namespace {

constexpr double kDeviationRounding = 1e-9;  // of a bound that a deviation is compared with

ExecutionLimits largest(const ExecutionLimits& before, const ExecutionLimits& now) {
  return {std::max(before.change, now.change), std::max(before.speed, now.speed)};
}

}  // namespace

ReferenceTracker::ReferenceTracker(const ExecutionModel& model, const Planner& planner) {
  const PlannerOptions& options = planner.options();
  validate(model, options.time_step);
  if (options.motion != Motion::held)
    throw Error("ReferenceTracker: motion: found exponential, must be held");
  const double steps = std::ceil(model.dead_time / options.time_step);
  state_ = std::make_unique<State>(State{.model = model, .response = step_response(planner)});
  state_->sent.resize(static_cast<std::size_t>(steps));
}
ReferenceTracker::~ReferenceTracker() = default;
ReferenceTracker::ReferenceTracker(ReferenceTracker&&) noexcept = default;
ReferenceTracker& ReferenceTracker::operator=(ReferenceTracker&&) noexcept = default;

ExecutionError ReferenceTracker::error(const Robot& body) const {
  return bounds_of(state_->model, body.model, largest(state_->limits, limits_of(body)),
                   state_->response.time_step);
}

namespace {

// m, from the reference; 0 where it begins at the body.
double deviation_of(const std::optional<MotionState>& reference, const Robot& body) {
  return reference ? norm(body.position - reference->position) : 0.0;
}

bool is_within(double deviation, const ExecutionError& error, const ExecutionModel& model) {
  return deviation <= (1.0 + kDeviationRounding) * (error.position + model.measured_position_error);
}

MotionState moved(const Robot& robot, const Plan& plan, const StepResponse& response) {
  const MotionState from{robot.position, robot.velocity, robot.heading};
  if (is_holonomic(robot.model)) return advance(from, plan, response).next;
  return advance(robot.model, {planned_braking(robot), robot.max_speed}, from, plan,
                 response.time_step)
      .next;
}

}  // namespace

Robot ReferenceTracker::reference(const Robot& body) const {
  const ExecutionError most = error(body);
  Robot led = body;
  led.radius += most.position;
  const std::optional<MotionState>& at = state_->reference;
  if (at && is_within(deviation_of(at, body), most, state_->model))
    led.position = at->position, led.velocity = at->velocity;
  return led;
}

BaseCommand ReferenceTracker::follow(const Robot& body, const Plan& plan) {
  State& state = *state_;
  const ExecutionModel& model = state.model;
  const double dt = state.response.time_step;
  BaseCommand command;
  command.deviation = deviation_of(state.reference, body);
  command.has_left = !is_within(command.deviation, error(body), model);
  const Robot led = reference(body);
  state.limits = largest(state.limits, limits_of(body));
  if (!state.has_sent) std::fill(state.sent.begin(), state.sent.end(), body.velocity);
  state.has_sent = true;
  const MotionState after = moved(led, plan, state.response);
  command.velocity =
      command_towards(model, after, body.position, body.velocity,
                      still_to_come(state.sent, state.next, model.dead_time, dt), dt);
  if (is_holonomic(body.model))  // the wheels of drives are rounded at each of their cycles
    command.velocity = executable(model, command.velocity);
  command.next_reference = after.position, command.next_velocity = after.velocity;
  state.reference = after;
  if (state.sent.empty()) return command;
  state.sent[state.next] = command.velocity;
  state.next = (state.next + 1) % state.sent.size();
  return command;
}

void ReferenceTracker::forget() {
  state_->reference.reset();
}

}  // namespace avo
