// SPDX-License-Identifier: Apache-2.0
// One robot's decision (paper §IV-D): collects a half-plane per neighbor, chooses the allowed
// velocity nearest the preferred one.
#include "avo/planner.h"

#include <algorithm>
#include <limits>

#include "certificate/discs.h"
#include "core/plane.h"
#include "planner/alone.h"
#include "planner/decision.h"
#include "planner/options.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/contact.h"
#include "planner/stages/cuts.h"
#include "planner/stages/execution.h"
#include "planner/stages/soft_planes.h"
#include "planner/together.h"
#include "planner/validity.h"
#include "robots/model.h"

namespace avo {
namespace {

// memory for more constraints is allocated when it is needed
constexpr std::size_t kMostConstraints = 8192;

}  // namespace

PlanWorkspace::PlanWorkspace() : scratch_(std::make_unique<Scratch>()) {}
PlanWorkspace::~PlanWorkspace() = default;
PlanWorkspace::PlanWorkspace(PlanWorkspace&&) noexcept = default;
PlanWorkspace& PlanWorkspace::operator=(PlanWorkspace&&) noexcept = default;

void PlanWorkspace::Scratch::reserve_choice(std::size_t neighbors, std::size_t braking_steps) {
  reserve_planes(neighbors, 0);
  reserve_constraints(neighbors, braking_steps, kMostConstraints, certified.constraints);
  reserve_constraints(neighbors, braking_steps, kMostConstraints, evasion.certified.constraints);
  evasion.around.reserve(neighbors, braking_steps);
  evasion.deciding.reserve(neighbors);
  evasion.certified.constraints.seen.reserve(neighbors);
  evasion.certified.constraints.alone.reserve(1);
  obstacles.reserve(neighbors);
  listed.reserve(neighbors);
}

void PlanWorkspace::Scratch::reserve_walls(std::size_t neighbors, std::size_t most_walls) {
  certified.constraints.walls.near.reserve(most_walls);
  evasion.certified.constraints.walls.near.reserve(most_walls);
  evasion.around.walls.reserve(most_walls);
  reserve_planes(neighbors, most_walls);
}

// Reserves room for the half-planes of one program, and for the cuts of its rounds.
void PlanWorkspace::Scratch::reserve_planes(std::size_t neighbors, std::size_t most_walls) {
  const std::size_t cuts = kMostCuts * (neighbors + most_walls) + kMostOwnPlanes;
  for (CertifiedWorkspace* own : {&certified, &evasion.certified}) {
    own->hard.reserve(cuts);
    own->rows.reserve(program_rows(cuts));
  }
  const std::size_t hard = most_walls + kMostOwnPlanes;
  demands.reserve(hard);
  hard_and_soft.reserve(neighbors + hard);
  rows.reserve(program_rows(neighbors + hard));
}

void PlanWorkspace::reserve(std::size_t neighbors, std::size_t braking_steps) {
  Scratch& scratch = *scratch_;
  scratch.reserve_choice(neighbors, braking_steps);
  scratch.order.reserve(neighbors);
  scratch.ordered.reserve(neighbors);
  scratch.alone.reserve(1, neighbors);
  scratch.decisions.reserve(1);
  avo::reserve(1, neighbors, scratch.soft);
}

Planner::Planner(const PlannerOptions& options) : options_(options) {
  validate(options, "PlannerOptions.");
  if (reaches_within_step(options.method)) options_.control_time = options.time_step;
  horizon_ = std::make_shared<const Horizon>(options_.control_time, options.time_horizon,
                                             options.time_step);
}

BrakingPose Planner::braking_pose(const Robot& robot) const {
  return avo::braking_pose(robot, certificate_law(*this).step);
}

Disc Planner::acceleration_disc(const Robot& robot) const {
  if (disregards_acceleration(options_.method))
    return {{}, std::numeric_limits<double>::infinity()};
  const double most = options_.control_time * robot.max_acceleration;
  return {robot.velocity, model_traits(robot.model).reach * most};
}

Disc Planner::speed_disc(const Robot& robot) const {
  return {{}, robot.max_speed};
}

double Planner::step_rate() const {
  if (adopts_at_once(options_.method)) return 1.0;
  return options_.motion == Motion::held ? options_.time_step / options_.control_time
                                         : horizon_->step().rate;
}

double Planner::step_lag() const {
  if (adopts_at_once(options_.method)) return 0.0;
  return options_.motion == Motion::held ? 0.5 * options_.time_step : horizon_->step().lag;
}

Plan Planner::plan(const Robot& robot, std::span<const Neighbor> neighbors,
                   PlanWorkspace& workspace, Detour* detour, std::span<const Wall> walls) const {
  return plan_alone(*this, robot, neighbors, workspace, detour, walls, NoTrace{});
}

}  // namespace avo

namespace avo::inline planner {
namespace {

Robot at_rest(Robot robot) {
  robot.velocity = {};
  return robot;
}

}  // namespace

template <typename Trace>
Plan plan_alone(const Planner& planner, const Robot& robot, std::span<const Neighbor> neighbors,
                PlanWorkspace& workspace, Detour* detour, std::span<const Wall> walls,
                Trace trace) {
  if (is_rest(robot.velocity) && robot.velocity != Vec2{})
    return plan_alone(planner, at_rest(robot), neighbors, workspace, detour, walls, trace);
  Detour next = detour != nullptr && is_sound(*detour) ? *detour : Detour{};
  Plan plan;
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  Tile& tile = scratch.alone;
  if (take_alone(robot, neighbors, walls, scratch)) {
    StageClock clock;
    tile.detour.push_back(&next);
    tile.plan.push_back(&plan);
    tile.remembers = detour != nullptr;
    plan_together(planner, tile, scratch, clock, trace);
    if (plan.neighbor >= 0)  // an index into the order of planning
      plan.neighbor =
          index_in(neighbors, tile.robots.neighbors[0][static_cast<std::size_t>(plan.neighbor)]);
  } else {
    plan = brake(planner, robot, PlanStatus::invalid_input, 0.0);
    remember(plan, next);
  }
  if (detour != nullptr) *detour = next;
  return with_next_velocity(planner, robot, plan);
}

template Plan plan_alone(const Planner&, const Robot&, std::span<const Neighbor>, PlanWorkspace&,
                         Detour*, std::span<const Wall>, NoTrace);
template Plan plan_alone(const Planner&, const Robot&, std::span<const Neighbor>, PlanWorkspace&,
                         Detour*, std::span<const Wall>, Recorder);

}  // namespace avo::inline planner
