// SPDX-License-Identifier: Apache-2.0
// A fleet for its users: by id, and in the order of ids.
#include "avo/simulation.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "avo/error.h"
#include "core/executor.h"
#include "core/hash.h"
#include "core/ranges.h"
#include "planner/decision.h"
#include "sim/clocks.h"
#include "sim/scene/complaints.h"
#include "sim/simulation_state.h"
#include "sim/state/saved_state.h"
#include "sim/travels.h"

namespace avo {
namespace {

constexpr int kMost = static_cast<int>(kMostWorkers);

std::shared_ptr<Executor> thread_pool(int threads) {
  if (threads < 0 || threads > kMost) {
    refuse("threads", std::to_string(threads), "0 (all there are) to " + std::to_string(kMost));
  }
  return make_executor(static_cast<std::size_t>(threads));
}

std::shared_ptr<Executor> checked(std::shared_ptr<Executor> executor) {
  if (executor == nullptr) refuse("executor", "none", "one that does the steps");
  const std::size_t workers = executor->workers();
  if (workers < 1 || workers > kMostWorkers)
    refuse("executor.workers", std::to_string(workers), "1 to " + std::to_string(kMost));
  return counted(std::move(executor));
}

// m, the robot's reported place.
Vec2 place_at_present(const World& world, std::size_t slot) {
  if (world.is_current) return world.fleet.body_place(slot);
  return world.fleet.place(slot, present_state(world, slot));
}

// m, the robot's reported place: of nearly all robots, that of the disc.
inline Vec2 place_now(const World& world, std::size_t slot) {
  const bool is_known =
      world.is_current && !world.fleet.traits[slot].has_model && world.fleet.bases.are_exact();
  return is_known ? world.fleet.position[slot] : place_at_present(world, slot);
}

}  // namespace

void lead_teams(Simulation& simulation, std::vector<Team>& teams) {
  for (Team& team : teams) lead(simulation, team);
}

void require_whole(const World& world, const char* call) {
  if (!world.torn) return;
  throw Error(std::string(call) +
              ": found an earlier step that ended in its midst, as memory or its "
              "executor failed, must be restored first");
}

std::unique_ptr<Simulation::State> Simulation::State::of(const Scenario& scenario,
                                                         std::shared_ptr<Executor> executor) {
  validate(scenario);
  require_assumptions(scenario);
  std::optional<Scenario> references;
  if (scenario.execution) references = with_references(scenario);
  auto state = std::make_unique<State>(references ? *references : scenario, std::move(executor));
  state->fleet.bases = bases_of(scenario);
  if (state->has_routes())
    state->travels =
        plan_travels(state->routes, state->fleet, state->floor, scenario.arrival_distance);
  return state;
}

std::unique_ptr<Simulation::State> Simulation::State::of(std::span<const std::byte> saved,
                                                         std::shared_ptr<Executor> executor) {
  const SavedState read = from_bytes(saved);
  auto state = std::make_unique<State>(read.scene, std::move(executor));
  state->fleet.bases = read.bases;
  avo::restore(read, *state);
  return state;
}

Simulation::Simulation(const Scenario& scenario, int threads)
    : state_(State::of(scenario, thread_pool(threads))) {
  lead_teams(*this, state_->settings.teams);
}
Simulation::Simulation(std::span<const std::byte> saved, int threads)
    : state_(State::of(saved, thread_pool(threads))) {}
Simulation::Simulation(const Scenario& scenario, std::shared_ptr<Executor> executor)
    : state_(State::of(scenario, checked(std::move(executor)))) {
  lead_teams(*this, state_->settings.teams);
}
Simulation::Simulation(std::span<const std::byte> saved, std::shared_ptr<Executor> executor)
    : state_(State::of(saved, checked(std::move(executor)))) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::set_external(ExternalMethod method) {
  state_->to_change().settings.external = std::move(method);
}

std::vector<std::byte> Simulation::save() const {
  require_whole(*state_, "Simulation::save");
  state_->catch_up();
  return to_bytes(saved_state(*state_));
}

void Simulation::restore(std::span<const std::byte> saved) {
  avo::restore(from_bytes(saved), state_->to_change());
  state_->nearby.has_walls = false;
  state_->forget_robots();
}

double Simulation::time() const {
  return state_->time();
}

std::int64_t Simulation::steps() const {
  return state_->steps;
}

double Simulation::sensing_radius() const {
  return state_->sensing_radius;
}

bool Simulation::can_step_by(double time) const {
  if (!state_->fleet.has_clocks) return state_->steps < last_step(state_->settings, time);
  constexpr double kRounding = 1e-12;  // of a sum of decimal fractions
  return seconds(next_instant(*state_)) <= time * (1.0 + kRounding);
}

double Simulation::next_decision(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  const std::size_t slot = fleet.find(robot);
  if (!fleet.decides(slot)) return std::numeric_limits<double>::infinity();
  return fleet.has_clocks ? seconds(fleet.clock_of(slot).end) : time();
}

bool Simulation::decided(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  const std::size_t slot = fleet.find(robot);
  if (!fleet.decides(slot)) return false;
  if (!fleet.has_clocks) return state_->steps > 0;
  const OwnClock& clock = fleet.clock_of(slot);
  return clock.has_decided && clock.begin == state_->before;
}

bool Simulation::is_at_goal(RobotId robot) const {
  const std::size_t slot = state_->fleet.find(robot);
  if (state_->fleet.is_parked(slot)) return true;
  if (!state_->fleet.heads_for_goal(slot)) return false;
  if (const Flight* flight = state_->fleet.flight(slot)) return flight->has_arrived;
  const Vec2 p = place_now(*state_, slot), goal = state_->fleet.goal[slot];
  const std::vector<Travel>& travels = state_->travels;
  const auto rank = static_cast<std::size_t>(state_->fleet.rank[slot]);
  const bool is_beside = !travels.empty() && travels[rank].ends == RouteEnd::beside;
  const double slack = is_beside ? kBesideSlack * state_->fleet.traits[slot].radius : 0.0;
  if (norm(goal - p) <= state_->arrival_distance(slot) + slack &&
      state_->routes_of(slot).is_in_sight(p, is_beside ? travels[rank].place : goal))
    return true;
  // so that goals are compared for few robots
  if (state_->fleet.has_stood[slot] == 0) return false;
  if (state_->has_new_goals) {
    const Lock lock(state_->looking);
    find_shared_goals(*state_);
  }
  state_->catch_up();
  return rests_at_place(*state_, slot);
}

bool Simulation::all_at_goal() const {
  const std::vector<RobotId>& ids = state_->fleet.id;
  return std::all_of(ids.begin(), ids.end(), [this](RobotId robot) { return is_at_goal(robot); });
}

Simulation::Route Simulation::route(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  const std::size_t slot = fleet.find(robot);
  const Vec2 p = place_now(*state_, slot), goal = fleet.goal[slot];
  if (state_->travels.empty() || fleet.is_parked(slot)) return {norm(goal - p), goal};
  return rest_of_route(state_->travels[static_cast<std::size_t>(fleet.rank[slot])], p, goal);
}

std::vector<RobotId> Simulation::unreachable() const {
  std::vector<RobotId> robots;
  const std::vector<Travel>& travels = state_->travels;
  for (std::size_t rank = 0; rank < travels.size(); ++rank) {
    if (travels[rank].ends == RouteEnd::short_of)
      robots.push_back(state_->fleet.id[state_->fleet.slot_of[rank]]);
  }
  return robots;
}

std::uint64_t Simulation::state_hash() const {
  state_->catch_up();
  const std::uint64_t present = hash_of(state_->fleet, state_->movers, state_->steps);
  const std::uint64_t bodies = hash_of(state_->fleet.bases, present);
  const std::uint64_t hash = state_->senses.remember() ? hash_of(state_->senses, bodies) : bodies;
  return state_->statics.id.empty() ? hash : mixed(hash, state_->statics.hash);
}

const Planner& Simulation::planner() const {
  return state_->planner();
}

const Planner& Simulation::planner(RobotId robot) const {
  return state_->pace(state_->fleet.find(robot)).planner;
}

void Simulation::measure(bool on) {
  for (Worker& worker : state_->workers) {
    worker.clock.measure(on);
    worker.pairs = worker.infeasible = 0;
  }
  state_->robot_steps = 0;
}

StepProfile Simulation::profile() const {
  StepProfile profile{state_->robot_steps, 0, 0, {}};
  for (std::size_t k = 0; k < kStageNames.size(); ++k) {
    double sum = 0.0;
    for (const Worker& worker : state_->workers) sum += worker.clock.nanoseconds(k);
    profile.stages.push_back({kStageNames[k], sum});
  }
  for (const Worker& worker : state_->workers) {
    profile.pairs += worker.pairs;
    profile.infeasible += worker.infeasible;
  }
  return profile;
}

int Simulation::threads() const {
  return static_cast<int>(state_->workers.size());
}

}  // namespace avo
