// SPDX-License-Identifier: Apache-2.0
// A fleet as its users see it: by id, and in the order of ids.
#include "avo/simulation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

#include "avo/error.h"
#include "core/hash.h"
#include "core/ranges.h"
#include "core/thread_pool.h"
#include "planner/decision.h"
#include "sim/edits.h"
#include "sim/saved_state.h"
#include "sim/world.h"

namespace avo {
namespace {

// What the robot counts on from another one; nothing of one that it does not mind as a neighbor.
std::optional<Behavior> expected_by(const World& world, std::size_t slot, std::size_t other) {
  const std::vector<Conduct>& conduct = world.fleet.conduct;
  if (conduct[slot].parked || conduct[other].parked) return std::nullopt;
  return expected_of(conduct[other], conduct[slot]);
}

// Whoever is within the sensing radius of a robot, found by looking at everyone.
std::vector<NeighborHit> all_hits(const World& world, std::size_t slot) {
  const Vec2 position = world.fleet.position[slot];
  const double radius = world.settings.sensing_radius;
  std::vector<NeighborHit> hits;
  if (world.fleet.conduct[slot].parked) return hits;
  const auto look = [&](Vec2 other, std::size_t number, bool is_obstacle) {
    const double distance_squared = norm_squared(other - position);
    if (!is_finite(other) || !is_finite(position)) return;
    if (!(distance_squared <= radius * radius)) return;
    hits.push_back({distance_squared, static_cast<int>(number), is_obstacle ? 1U : 0U});
  };
  for (std::size_t rank = 0; rank < world.fleet.size(); ++rank) {
    const std::uint32_t other = world.fleet.slot_of[rank];
    if (other != slot && expected_by(world, slot, other))
      look(world.fleet.position[other], rank, false);
  }
  for (std::size_t k = 0; k < world.obstacles.setup.size(); ++k) {
    look(world.obstacles.position[k], k, true);
  }
  // robots lie before obstacles and ids ascend
  std::stable_sort(hits.begin(), hits.end(), [](const NeighborHit& a, const NeighborHit& b) {
    return a.distance_squared < b.distance_squared;
  });
  return hits;
}

std::unique_ptr<Executor> thread_pool(int threads) {
  constexpr int kMost = static_cast<int>(kMostWorkers);
  if (threads < 0 || threads > kMost) {
    refuse("threads", std::to_string(threads), "0 (all there are) to " + std::to_string(kMost));
  }
  return std::make_unique<ThreadPool>(threads > 0 ? static_cast<std::size_t>(threads)
                                                  : std::min(usable_processors(), kMostWorkers));
}

void require_whole(const World& world, const char* call) {
  if (!world.torn) return;
  throw Error(std::string(call) + ": memory ran out in the midst of an earlier step");
}

}  // namespace

struct Simulation::State : World {
  using World::World;

  // in the order of ids; made when it is asked for
  std::mutex looking;
  std::atomic<bool> is_mirrored = false;
  FleetMirror mirror;
};

Simulation::Simulation(const Scenario& scenario, int threads) {
  validate(scenario);
  state_ = std::make_unique<State>(scenario, thread_pool(threads));
  plan_travels(state_->ways, state_->fleet);
}
Simulation::Simulation(std::span<const std::byte> saved, int threads) {
  const SavedState state = from_bytes(saved);
  state_ = std::make_unique<State>(state.scene, thread_pool(threads));
  avo::restore(state, *state_);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step() {
  require_whole(*state_, "Simulation::step");
  state_->is_mirrored = false;
  avo::step(*state_);
}

RobotId Simulation::add_robot(const RobotSetup& setup) {
  const RobotId robot = avo::add_robot(*state_, setup);
  state_->is_mirrored = false;
  return robot;
}

void Simulation::remove_robot(RobotId robot) {
  avo::remove_robot(*state_, robot);
  state_->is_mirrored = false;
}

void Simulation::set_goal(RobotId robot, Vec2 goal) {
  avo::set_goal(*state_, robot, goal);
  state_->is_mirrored = false;
}

ObstacleId Simulation::add_obstacle(const StaticObstacle& obstacle) {
  return avo::add_obstacle(*state_, obstacle);
}

void Simulation::remove_obstacle(ObstacleId obstacle) {
  avo::remove_obstacle(*state_, obstacle);
}

std::vector<std::byte> Simulation::save() const {
  require_whole(*state_, "Simulation::save");
  return to_bytes(saved_state(*state_));
}

void Simulation::restore(std::span<const std::byte> saved) {
  avo::restore(from_bytes(saved), *state_);
  state_->is_mirrored = false;
}

FleetView Simulation::fleet() const {
  State& state = *state_;
  if (!state.is_mirrored) {
    const std::lock_guard lock(state.looking);
    if (!state.is_mirrored) state.mirror.copy(state.fleet);
    state.is_mirrored = true;
  }
  return state.mirror.view();
}

ObstacleView Simulation::obstacles() const {
  const ObstacleColumns& o = state_->obstacles;
  return {o.position, o.velocity, o.setup};
}

StaticObstacleView Simulation::static_obstacles() const {
  return {state_->statics.id, state_->statics.obstacles};
}

double Simulation::time() const {
  return static_cast<double>(state_->steps) * state_->settings.time_step;
}

std::int64_t Simulation::steps() const {
  return state_->steps;
}

bool Simulation::is_at_goal(std::size_t robot) const {
  const std::uint32_t slot = state_->fleet.slot_of[robot];
  if (state_->fleet.conduct[slot].parked) return true;
  const Vec2 p = state_->fleet.position[slot], goal = state_->fleet.goal[slot];
  return norm(goal - p) <= state_->settings.arrival_distance && state_->ways.is_in_sight(p, goal);
}

bool Simulation::all_at_goal() const {
  for (std::size_t i = 0; i < state_->fleet.size(); ++i) {
    if (!is_at_goal(i)) return false;
  }
  return true;
}

std::vector<RobotId> Simulation::unreachable() const {
  std::vector<RobotId> robots;
  const std::vector<Travel>& travels = state_->ways.travels;
  for (std::size_t rank = 0; rank < travels.size(); ++rank) {
    if (travels[rank].target == Travel::kUnreachable)
      robots.push_back(state_->fleet.id[state_->fleet.slot_of[rank]]);
  }
  return robots;
}

std::uint64_t Simulation::state_hash() const {
  const std::uint64_t hash = hash_of(state_->fleet, state_->obstacles, state_->steps);
  return state_->statics.id.empty() ? hash : mixed(hash, state_->statics.hash);
}

Simulation::Perception Simulation::perceive(std::size_t robot) const {
  State& state = *state_;
  if (state.changed) {
    const std::lock_guard lock(state.looking);
    find_walls(state);
  }
  const std::uint32_t slot = state.fleet.slot_of[robot];
  const std::vector<NeighborHit> hits = all_hits(state, slot);
  const double nearest = hits.empty() ? std::numeric_limits<double>::infinity()
                                      : std::sqrt(hits.front().distance_squared);
  Perception seen{state.robot(slot, nearest), {}, {}, state.fleet.detour[slot], false, {}};
  for (const NeighborHit& hit : hits) {
    if (!state.all_matter() && seen.source.size() == state.most_nearest()) break;
    const auto k = static_cast<std::size_t>(hit.index);
    const bool is_obstacle = hit.place != 0;
    const std::uint32_t other = is_obstacle ? 0 : state.fleet.slot_of[k];
    seen.neighbors.push_back(is_obstacle
                                 ? state.obstacles.sensed(k)
                                 : state.fleet.sensed(other, *expected_by(state, slot, other)));
    seen.source.push_back(is_obstacle ? -1 - hit.index : hit.index);
  }
  const std::span<const Wall> walls = state.statics.grid.near(seen.robot.position);
  seen.walls.assign(walls.begin(), walls.end());
  seen.among_movers = is_among_movers(state.planner.options(), seen.neighbors);
  return seen;
}

const Planner& Simulation::planner() const {
  return state_->planner;
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
