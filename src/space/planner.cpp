// SPDX-License-Identifier: Apache-2.0
#include "avo/space/planner.h"

#include <algorithm>
#include <array>

#include "space/boxes.h"
#include "space/certificate.h"
#include "space/decide.h"
#include "space/horizons.h"
#include "space/kernels.h"
#include "space/own_space.h"
#include "space/step_law.h"
#include "space/trace.h"
#include "space/validity.h"
#include "space/workspace.h"

namespace avo::space {

PlanWorkspace::PlanWorkspace() : scratch_(std::make_unique<Scratch>()) {}
PlanWorkspace::~PlanWorkspace() = default;
PlanWorkspace::PlanWorkspace(PlanWorkspace&&) noexcept = default;
PlanWorkspace& PlanWorkspace::operator=(PlanWorkspace&&) noexcept = default;

namespace {

void gather(std::span<const Neighbor> neighbors, const StepLaw& law, Bodies& bodies) {
  bodies.clear();
  bodies.reserve(neighbors.size());
  for (const Neighbor& neighbor : neighbors) bodies.add(neighbor, bodies.count);
  fill_braking(law, bodies);
}

// What a robot is given.
struct Given {
  const Robot& robot;
  std::span<const Neighbor> neighbors;
  std::span<const Box> boxes;
  std::span<const Mover> movers;
};

template <typename Trace>
Plan plan_in(PlanWorkspace::Scratch& scratch, const PlannerOptions& options,
             std::span<const Horizon> horizons, const Given& given, Detour* detour, Trace trace) {
  const auto& [robot, neighbors, boxes, movers] = given;
  const StepLaw law = step_law(options, horizons.front());
  if (!are_valid(robot, neighbors, boxes, movers)) {
    Plan plan = is_valid(robot) ? braking_plan(robot, law) : Plan{};
    plan.status = PlanStatus::invalid_input;
    return plan;
  }
  gather(neighbors, law, scratch.bodies);
  const Run all{0, neighbors.size()};
  Detour next = detour != nullptr ? *detour : Detour{};
  const Tempo tempo = tempo_of(robot, {response_law(options), law.lag, law.braking_time});
  const Plan plan = decide(
      options, horizons, law, robot, tempo,
      {.bodies = scratch.bodies, .runs = std::span(&all, 1), .boxes = boxes, .movers = movers},
      detour != nullptr, scratch, next, trace);
  if (detour != nullptr) *detour = next;
  return plan;
}

}  // namespace

Planner::Planner(const PlannerOptions& options)
    : options_(options), horizons_(horizons_of(options)) {
  validate_in_space(options);
}

Plan Planner::plan(const Robot& robot, std::span<const Neighbor> neighbors,
                   PlanWorkspace& workspace, Detour* detour, std::span<const Box> boxes,
                   std::span<const Mover> movers) const {
  return plan_in(*workspace.scratch_, options_, horizons_, {robot, neighbors, boxes, movers},
                 detour, NoTrace{});
}

DecisionTrace Planner::explain(const Robot& robot, std::span<const Neighbor> neighbors,
                               PlanWorkspace& workspace, Detour* detour, std::span<const Box> boxes,
                               std::span<const Mover> movers) const {
  TraceRecord record{{}, boxes, movers};
  DecisionTrace& trace = record.decision;
  trace.preferred_velocity = trace.wish = trace.aim = robot.preferred_velocity;
  trace.plan = plan_in(*workspace.scratch_, options_, horizons_, {robot, neighbors, boxes, movers},
                       detour, Recorder{&record});
  if (trace.plan.status == PlanStatus::invalid_input)
    trace.target = trace.proposal = trace.plan.next_velocity;
  return trace;
}

bool Planner::is_admitted(const Robot& robot, std::span<const Neighbor> neighbors,
                          PlanWorkspace& workspace, Vec3 next_velocity, std::span<const Box> boxes,
                          std::span<const Mover> movers) const {
  if (!are_valid(robot, neighbors, boxes, movers) || !is_finite(next_velocity)) return false;
  const StepLaw law = step_law(options_, horizons_.front());
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  const Vec3 own = to_own(next_velocity, robot.vertical);
  const double change = norm(own - to_own(robot.velocity, robot.vertical));
  if (change > robot.max_acceleration * law.braking_time || norm(own) > robot.max_speed ||
      next_velocity.z > robot.climb || -next_velocity.z > robot.sink)
    return false;
  gather(neighbors, law, scratch.bodies);
  const Run all{0, neighbors.size()};
  Constraints& constraints = admission_of(
      options_, horizons_, law, robot,
      {.bodies = scratch.bodies, .runs = std::span(&all, 1), .boxes = boxes, .movers = movers},
      scratch);
  return admits(robot, next_velocity, law, Asked::until_refused, constraints);
}

double Planner::step_lag() const {
  return step_law(options_, horizons_.front()).lag;
}

namespace {

StepLaw checked_law(const PlannerOptions& options) {
  validate_in_space(options);
  return step_law(options, Horizon(options.control_time, options.time_horizon, options.time_step));
}

// m: how far a robot gets in a step and in stopping from its highest speed, with its radius.
double reach_of(const Robot& robot, const StepLaw& law) {
  const double fastest = robot.max_speed * std::max(robot.vertical, 1.0);
  const Vec3 top = robot.vertical > 1.0 ? Vec3{0.0, 0.0, fastest} : Vec3{fastest, 0.0, 0.0};
  return robot.radius + robot.downwash +
         braking_of(top, robot.max_acceleration, braking_limit(robot), robot.vertical, law).reach;
}

}  // namespace

double box_range(const Robot& robot, const PlannerOptions& options) {
  // from where the robot takes itself to be
  return (1.0 + 1e-9) * box_reach(robot, checked_law(options)) + 2.0 * options.localization_error;
}

double sensing_range(const Robot& robot, const Mover& mover, const PlannerOptions& options) {
  const StepLaw law = checked_law(options);
  const double steps = 3.0 + robot.max_speed / (braking_limit(robot) * law.braking_time);
  const double t = law.time_step * steps;
  const double length =
      t * norm(mover.velocity) + 0.5 * t * t * (norm(mover.acceleration) + mover.max_deviation);
  return (1.0 + 1e-9) *
             (reach_of(robot, law) + mover.radius + std::min(length, t * mover.max_speed)) +
         options.sensing_error.position + t * options.sensing_error.velocity;
}

double sensing_range(const Robot& robot, const Robot& other, const PlannerOptions& options) {
  const StepLaw law = checked_law(options);
  return (1.0 + 1e-9) * (reach_of(robot, law) + reach_of(other, law)) +
         options.sensing_error.position;
}

}  // namespace avo::space
