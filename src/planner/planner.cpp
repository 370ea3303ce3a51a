// SPDX-License-Identifier: Apache-2.0
// One robot's decision (paper §IV-D): collect a half-plane per neighbor, choose the allowed
// velocity nearest the preferred one.
#include "avo/planner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "avo/half_plane.h"
#include "core/elementary.h"
#include "core/ranges.h"
#include "lp/lens.h"
#include "lp/linear_program.h"
#include "planner/arrival.h"
#include "planner/braking.h"
#include "planner/decision.h"
#include "planner/neighbor_order.h"
#include "planner/options.h"
#include "planner/passive_obstacles.h"
#include "planner/scratch.h"
#include "planner/soft_planes.h"

namespace avo {
namespace {

// Radii and limits whose squares, and those of what is made of them, neither over- nor underflow.
constexpr double kSmallest = 1e-60;

// 1 or 0, to be joined without a branch: nearly all are.
int is_known(double value) {
  return static_cast<int>(std::abs(value) <= kLargest);
}
int is_known(Vec2 value) {
  return is_known(value.x) & is_known(value.y);
}
int is_size(double value) {
  return static_cast<int>(value >= kSmallest) & static_cast<int>(value <= kLargest);
}

// Where the robot is does not matter for slowing down.
bool can_brake(const Robot& robot) {
  const int velocity = is_known(robot.velocity);
  return (velocity & is_size(robot.max_acceleration) & is_size(robot.max_speed)) != 0;
}

}  // namespace

bool is_valid(const Robot& robot) {
  const int places = is_known(robot.position) & is_known(robot.preferred_velocity);
  const int lengths = is_size(robot.radius) & static_cast<int>(robot.distance_to_goal >= 0.0);
  return can_brake(robot) && (places & lengths) != 0 &&
         (!robot.car || (is_known(robot.car->heading) & is_size(robot.car->wheelbase)) != 0);
}

bool follows_heading(const Robot& robot) {
  if (!robot.car) return true;
  const Vec2 v = robot.velocity, heading = elementary::direction(robot.car->heading);
  return norm_squared(v - norm(v) * heading) <=
         kHeadingTolerance * kHeadingTolerance * norm_squared(v);
}

bool is_valid(const Neighbor& neighbor) {
  const auto [p, v, r, a_max, a] = neighbor;
  const int decides = static_cast<int>(a_max >= 0.0) & static_cast<int>(a_max <= kLargest);
  return (is_known(p) & is_known(v) & is_known(a) & is_size(r) & decides) != 0;
}

bool all_valid(const Robot& robot, std::span<const Neighbor> neighbors) {
  return is_valid(robot) && std::all_of(neighbors.begin(), neighbors.end(),
                                        [](const Neighbor& n) { return is_valid(n); });
}

bool all_valid(const Robot& robot, const Neighbors& neighbors) {
  if (!is_valid(robot)) return false;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    if (!is_valid(neighbors[k])) return false;
  }
  return true;
}

bool can_follow(const Robot& robot, const PlannerOptions& options) {
  return !robot.car || options.certificate == Certificate::none || options.motion == Motion::held;
}

const char* to_string(PlanStatus status) {
  switch (status) {
    case PlanStatus::optimal:
      return "optimal";
    case PlanStatus::least_unsafe:
      return "least_unsafe";
    case PlanStatus::candidate:
      return "candidate";
    case PlanStatus::braking:
      return "braking";
    case PlanStatus::overlapping:
      return "overlapping";
    case PlanStatus::invalid_input:
      return "invalid_input";
  }
  return "unknown";
}

PlanWorkspace::PlanWorkspace() : scratch_(std::make_unique<Scratch>()) {}
PlanWorkspace::~PlanWorkspace() = default;
PlanWorkspace::PlanWorkspace(PlanWorkspace&&) noexcept = default;
PlanWorkspace& PlanWorkspace::operator=(PlanWorkspace&&) noexcept = default;

namespace {

constexpr std::size_t kMostWalls = 8192;  // of more, memory grows when it is needed
}  // namespace

void PlanWorkspace::Scratch::reserve_choice(std::size_t neighbors, std::size_t braking_steps) {
  rows.reserve(program_rows(neighbors));
  certified.hard.reserve(kMostCuts * neighbors);
  certified.rows.reserve(program_rows(kMostCuts * neighbors));
  reserve_walls(neighbors, braking_steps, kMostWalls, certified.walls);
}

void PlanWorkspace::reserve(std::size_t neighbors, std::size_t braking_steps) {
  planes.reserve(neighbors);
  certificate.reserve(std::min(neighbors * braking_steps, kMostWalls));
  Scratch& scratch = *scratch_;
  scratch.reserve_choice(neighbors, braking_steps);
  scratch.order.reserve(neighbors);
  scratch.ordered.reserve(neighbors);
  scratch.seen.reserve(neighbors);
  scratch.deciding.reserve(1);
  scratch.sensing.reserve(1);
  scratch.wishes.reserve(1);
  scratch.columns.reserve(1);
  scratch.results.reserve(1);
  avo::reserve(1, neighbors, scratch.soft);
}

Planner::Planner(const PlannerOptions& options) : options_(options) {
  validate(options);
  horizon_ = std::make_shared<const Horizon>(options.control_time, options.time_horizon,
                                             options.time_step);
}

Disc Planner::acceleration_disc(const Robot& robot) const {
  if (adopts_at_once(options_.method)) return {{}, std::numeric_limits<double>::infinity()};
  return {robot.velocity, options_.control_time * robot.max_acceleration};
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

void Planner::collect_half_planes(const Robot& robot, std::span<const Neighbor> neighbors,
                                  PlanWorkspace& workspace) const {
  workspace.planes.clear();
  workspace.overlapping = false;
  if (!all_valid(robot, neighbors)) return;
  const Lens allowed = make_lens(acceleration_disc(robot), robot.max_speed);
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  for (const std::uint32_t k : list_nearest(options_, robot, neighbors, scratch)) {
    const Neighbor& neighbor = neighbors[k];
    const RelativeHalfPlane relative = relative_half_plane(options_, *horizon_, robot, neighbor);
    if (relative.state == PairState::free) continue;
    if (relative.state == PairState::overlapping || relative.state == PairState::coincident) {
      workspace.overlapping = true;
    }
    if (relative.state == PairState::coincident) continue;

    const NeighborPlane own = share_of(options_, robot, neighbor, static_cast<int>(k), relative);
    if (own.excess <= 0.0 && lens_support_min(own.plane.normal, allowed) >= own.plane.offset) {
      continue;
    }
    workspace.planes.push_back(own);
  }
}

Plan Planner::brake(const Robot& robot, PlanStatus status, double violation) const {
  if (!can_brake(robot)) return {{}, {}, PlanStatus::invalid_input, 0.0};
  if (adopts_at_once(options_.method)) return finish(robot, {}, status, violation);
  if (options_.method == Method::avo) {
    return step_to(robot, backup_velocity(robot, certificate_law(*this)), status, violation);
  }
  return finish(robot, braking_velocity(robot, options_.control_time, step_rate()), status,
                violation);
}

Plan Planner::plan(const Robot& robot, std::span<const Neighbor> neighbors,
                   PlanWorkspace& workspace) const {
  Detour detour;
  return plan(robot, neighbors, workspace, detour);
}

Plan Planner::plan(const Robot& robot, std::span<const Neighbor> neighbors,
                   PlanWorkspace& workspace, Detour& detour) const {
  Detour next = is_sound(detour) ? detour : Detour{};
  if (!all_valid(robot, neighbors) || !follows_heading(robot)) {
    detour = next;
    return brake(robot, PlanStatus::invalid_input, 0.0);
  }
  Plan plan;
  StageClock clock;
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  const Neighbors seen = in_columns(nearest_first(robot, neighbors, scratch), scratch.seen);
  const Deciding alone{{&robot, seen, true}, &next, &plan};
  plan_together(*this, {&alone, 1}, workspace, clock);
  detour = next;
  return plan;
}

Plan Planner::plan_among_obstacles(const Robot& robot, std::span<const Neighbor> given,
                                   PlanWorkspace& workspace) const {
  if (!all_valid(robot, given) || !follows_heading(robot) || !can_follow(robot, options_)) {
    return brake(robot, PlanStatus::invalid_input, 0.0);
  }
  const std::span<const Neighbor> obstacles = nearest_first(robot, given, *workspace.scratch_);
  const Response response = adopts_at_once(options_.method)
                                ? Response::velocity()
                                : Response::proportional(options_.control_time);
  bool overlapping = false;
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  scratch.obstacles.clear();
  for (const Neighbor& each : obstacles) {
    const Pair pair = relative(robot, each);
    overlapping = overlapping || norm(pair.position) < pair.radius;
    const Vec2 v_new_B =
        each.velocity +
        (response.control_time() * (each.max_acceleration > 0.0 ? 0.0 : 1.0)) * each.acceleration;
    scratch.obstacles.push_back(
        {{pair, response, options_.time_horizon}, v_new_B, options_.time_step});
  }
  // Eq. (14)
  const PassiveChoice choice =
      choose_among_obstacles(scratch.obstacles, acceleration_disc(robot), speed_disc(robot),
                             robot.preferred_velocity, scratch.passive);
  if (choice.state == PassiveState::discs_disjoint) {
    return brake(robot, PlanStatus::braking, choice.violation);
  }
  if (options_.method == Method::avo) {
    return certify(robot, obstacles, choice.velocity, choice.violation, overlapping, workspace);
  }
  const PlanStatus status = overlapping                          ? PlanStatus::overlapping
                            : choice.state == PassiveState::free ? PlanStatus::optimal
                                                                 : PlanStatus::least_unsafe;
  return finish(robot, choice.velocity, status, choice.violation);
}

}  // namespace avo
