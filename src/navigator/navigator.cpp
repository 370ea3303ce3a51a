// SPDX-License-Identifier: Apache-2.0
#include "avo/navigator.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "avo/error.h"
#include "core/plane.h"
#include "core/ranges.h"
#include "navigator/plan_routes.h"
#include "navigator/state.h"
#include "planner/decision.h"
#include "planner/stages/certify.h"
#include "planner/validity.h"
#include "robots/model.h"

namespace avo::inline navigator {
namespace {

constexpr double kLate = 1.5;  // steps: so long after the last cycle, a cycle has been left out

// A navigator may meet movers: its evasive maneuvers need all walls within their reach.
PlannerOptions with_all_walls(PlannerOptions options) {
  options.wall_range = kInfinity;
  return options;
}

}  // namespace

NavigatorState::NavigatorState(const NavigatorOptions& given, std::vector<Wall> walls)
    : options(given),
      planner(with_all_walls(given.planner)),
      response(step_response(planner)),
      map(std::move(walls)) {
  memory.routes = std::make_shared<Routes>(route_rules_of(options), map, std::vector<Wall>{});
  if (options.execution) tracker.emplace(*options.execution, planner);
}

void NavigatorState::take_map(std::vector<Wall> walls) {
  memory.routes =
      std::make_shared<Routes>(route_rules_of(options), walls, memory.routes->resting());
  map = std::move(walls);
  needs.reset();
  memory.travel = {}, memory.on.back.reset(), memory.is_planned = false;
  memory.passages_for = 0.0;
}

void NavigatorState::begin(Mission next) {
  if (next == mission) return;
  mission = std::move(next);
  Memory fresh;  // as Simulation::set_goal()
  fresh.routes = memory.routes, fresh.passages_for = memory.passages_for;
  fresh.detour.congestion = memory.detour.congestion;
  fresh.detour.acceleration_x = memory.detour.acceleration_x;
  fresh.detour.acceleration_y = memory.detour.acceleration_y;
  fresh.decisions = memory.decisions, fresh.time = memory.time;
  memory = std::move(fresh);
}

namespace {

// On board, a robot has no id: it is known by its index in the neighbors given.
std::optional<NavigatorWait> wait_of(const std::optional<Simulation::Wait>& wait) {
  if (!wait) return std::nullopt;
  return NavigatorWait{wait->passage, static_cast<int>(wait->robot.value), wait->inside, wait->a,
                       wait->b};
}

// A base that does not execute exactly has a reference, which decides in its place.
Robot deciding(const NavigatorState& state, const Robot& body) {
  return state.tracker ? state.tracker->reference(body) : body;
}

// Returns whether a cycle has been left out, which leaves the reference behind.
bool forgets_late(NavigatorState& state, double time) {
  if (!state.tracker) return false;
  const double time_step = state.planner.options().time_step;
  const bool is_late = state.followed && time - *state.followed > kLate * time_step;
  if (is_late) state.tracker->forget();
  return is_late;
}

std::optional<BaseCommand> followed(NavigatorState& state, const Robot& body, const Plan& plan,
                                    double time, bool is_late) {
  if (!state.tracker) return {};
  BaseCommand command = state.tracker->follow(body, plan);
  command.has_left |= is_late;
  state.followed = time;
  return command;
}

// The decision on values with which nothing can be decided.
NavigatorDecision invalid(NavigatorState& state, const Robot& body, double time) {
  const bool is_led =
      state.tracker && std::isfinite(time) && all_valid(body, std::span<const Neighbor>{});
  const bool is_late = is_led && forgets_late(state, time);
  const Robot robot = is_led ? deciding(state, body) : body;
  NavigatorDecision decision;
  decision.status = NavigatorStatus::under_way;
  decision.plan = with_next_velocity(state.planner, robot,
                                     brake(state.planner, robot, PlanStatus::invalid_input, 0.0));
  remember(decision.plan, state.memory.detour);
  if (is_led) {
    decision.command = followed(state, body, decision.plan, time, is_late);
  } else if (state.tracker) {  // of the body itself nothing is known
    state.tracker->forget();
    const Vec2 next = decision.plan.next_velocity;
    decision.command = {next, body.position, next, 0.0, true};
  }
  return decision;
}

void require_rest(const Robot& robot) {
  if (!can_rest(robot.model))
    throw Error("Navigator: robot: found one that cannot stop, must be one that can");
}

}  // namespace
}  // namespace avo::inline navigator

namespace avo {

struct Navigator::State : NavigatorState {
  using NavigatorState::NavigatorState;
};

namespace {

void validate(const NavigatorOptions& options) {
  const std::string prefix = "NavigatorOptions.";
  const auto at = [&](const char* name) { return prefix + name; };
  if (options.preferred_speed)
    require(at("preferred_speed"), *options.preferred_speed, kNotNegative, "m/s");
  for (const double radius : options.fleet_radii)
    require(at("fleet_radii"), radius, kPositive, "m");
  if (options.xy_goal_tolerance)
    require(at("xy_goal_tolerance"), *options.xy_goal_tolerance, kPositive, "m");
  require(at("yaw_goal_tolerance"), options.yaw_goal_tolerance, kPositive, "rad");
  require(at("required_movement_radius"), options.required_movement_radius, kPositive, "m");
  require(at("movement_time_allowance"), options.movement_time_allowance, kPositive, "s");
  if (options.route_tolerance)
    require(at("route_tolerance"), *options.route_tolerance, kPositive, "m");
}

// The walls that a robot in those layers heeds.
std::vector<Wall> checked_walls(std::vector<StaticObstacle> obstacles, LayerSet layers) {
  Scenario scene;
  scene.obstacles = std::move(obstacles);
  validate(scene);
  return walls_of(heeded(scene.obstacles, layers));
}

void check(const std::vector<Stage>& stages, const std::optional<double>& heading) {
  for (const Stage& stage : stages) {
    require("Navigator: position", stage.position, "m");
    if (stage.wait != kInfinity) require("Navigator: wait", stage.wait, kNotNegative, "s");
  }
  if (heading) require("Navigator: heading", *heading, kAngle, "rad");
}

}  // namespace

const char* to_string(NavigatorStatus status) {
  switch (status) {
    case NavigatorStatus::idle:
      return "idle";
    case NavigatorStatus::under_way:
      return "under_way";
    case NavigatorStatus::waiting:
      return "waiting";
    case NavigatorStatus::reached:
      return "reached";
    case NavigatorStatus::stuck:
      return "stuck";
    case NavigatorStatus::unreachable:
      return "unreachable";
  }
  return "?";
}

Navigator::Navigator(const NavigatorOptions& options, std::vector<StaticObstacle> obstacles) {
  validate(options);
  state_ = std::make_unique<State>(options, checked_walls(std::move(obstacles), options.layers));
}
Navigator::~Navigator() = default;
Navigator::Navigator(Navigator&&) noexcept = default;
Navigator& Navigator::operator=(Navigator&&) noexcept = default;

void Navigator::set_goal(Vec2 goal, std::optional<double> heading, bool is_shared) {
  Mission mission{Mission::Kind::goal, {{goal}}, heading, is_shared};
  check(mission.stages, heading);
  state_->begin(std::move(mission));
}

void Navigator::set_route(std::vector<Vec2> points, std::optional<double> heading) {
  if (points.size() < 2)
    refuse("Navigator: route", std::to_string(points.size()) + " points", ">= 2 points");
  Mission mission{Mission::Kind::route, {}, heading};
  for (const Vec2 point : points) mission.stages.push_back({point});
  check(mission.stages, heading);
  state_->begin(std::move(mission));
}

void Navigator::set_stages(std::vector<Stage> stages, std::optional<double> heading) {
  if (stages.empty()) refuse("Navigator: stages", "none", "one or more");
  check(stages, heading);
  state_->begin({Mission::Kind::stages, std::move(stages), heading});
}

void Navigator::go_on() {
  OnRoute& on = state_->memory.on;
  if (!on.is_given() || on.is_last() || on.waited == 0.0) return;
  on.along = on.next().along;
  ++on.stop, on.waited = 0.0;
}

void Navigator::clear_goal() {
  state_->begin({});
}

void Navigator::set_obstacles(std::vector<StaticObstacle> obstacles,
                              std::optional<LayerSet> layers) {
  const LayerSet own = layers.value_or(state_->options.layers);
  state_->take_map(checked_walls(std::move(obstacles), own));
  state_->options.layers = own;
}

NavigatorDecision Navigator::step(const Robot& body, std::span<const Neighbor> neighbors,
                                  double time) {
  require_rest(body);
  NavigatorState& state = *state_;
  Memory& memory = state.memory;
  const bool is_later = std::isfinite(time) && (!memory.time || time >= *memory.time);
  if (!is_later || !all_valid(body, neighbors)) return invalid(state, body, time);
  const bool is_late = forgets_late(state, time);
  const Robot robot = deciding(state, body);
  const double since = memory.time ? time - *memory.time : state.planner.options().time_step;
  const SetOut out = set_out(state, memory, robot, neighbors, since);
  NavigatorDecision decision;
  decision.plan =
      state.planner.plan(out.robot, neighbors, state.workspace, &memory.detour, out.walls);
  if (out.stops && decision.plan.status != PlanStatus::overlapping) {
    const SafetyState proved = decision.plan.state;
    decision.plan = stop_of(state.planner, state.response, robot);
    decision.plan.state = proved;
    remember(decision.plan, memory.detour);
  }
  decision.command = followed(state, body, decision.plan, time, is_late);
  memory.time = time;
  ++memory.decisions;
  decision.status = status_of(state, robot, since);
  decision.guide = out.guide, decision.wait = wait_of(out.wait);
  decision.preferred_velocity = out.robot.preferred_velocity;
  const Simulation::Route route = route_left(state, memory, robot);
  decision.route_left = route.length, decision.distance_left = route.distance_left;
  const StepLaw law = certificate_law(state.planner).step;
  decision.stopping_distance = stopping_length(norm(robot.velocity), decrement_of(robot, law), law);
  decision.without_progress = memory.progress.time;
  return decision;
}

std::vector<Vec2> Navigator::route() const {
  const Memory& memory = state_->memory;
  std::vector<Vec2> corners;
  if (!memory.is_planned || !state_->mission.has_goal()) return corners;
  const Travel travel = memory.on.is_given() ? as_travel(memory.on) : memory.travel;
  for (std::uint32_t at = travel.target; travel.is_known() && at < PathMap::kNothing;
       at = travel.map->after(at))
    corners.push_back(travel.graph->points[at]);
  corners.push_back(end_of(state_->mission, memory));
  return corners;
}

const Detour& Navigator::detour() const {
  return state_->memory.detour;
}

const Planner& Navigator::planner() const {
  return state_->planner;
}

const NavigatorOptions& Navigator::options() const {
  return state_->options;
}

Explanation Navigator::explain(const Robot& robot, std::span<const Neighbor> neighbors) const {
  require_rest(robot);
  const bool is_led = state_->tracker && all_valid(robot, neighbors);
  return explanation_of(*state_, is_led ? deciding(*state_, robot) : robot, neighbors);
}

}  // namespace avo
