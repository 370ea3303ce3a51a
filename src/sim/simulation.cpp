// SPDX-License-Identifier: Apache-2.0
// The sensing-acting cycle of a fleet (paper §IV-D): all robots decide from the same generation,
// each alone, then all move.
#include "avo/simulation.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <string_view>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "core/parallel.h"
#include "neighbors/uniform_grid.h"
#include "robots/motion.h"
#include "sim/fleet.h"
#include "sim/goals.h"

namespace avo {
namespace {

// What one worker needs to plan for one robot after the other without allocating.
struct Worker {
  PlanWorkspace plan;
  std::vector<NeighborHit> robots, obstacles;
  std::vector<Neighbor> neighbors;
  std::vector<int> source;

  // Room for so many within the sensing radius: a crowd that thickens in mid-run allocates nothing.
  void reserve(std::size_t all_robots, std::size_t all_obstacles, std::size_t most) {
    constexpr std::size_t kMostAhead = 4096;  // of more, memory grows when it is needed
    robots.reserve(std::min(all_robots, kMostAhead));
    obstacles.reserve(std::min(all_obstacles, kMostAhead));
    neighbors.reserve(std::min({all_robots + all_obstacles, most, kMostAhead}));
    source.reserve(neighbors.capacity());
  }
};

}  // namespace

struct Simulation::State {
  Scenario settings;  // without its robots and obstacles
  Planner planner;
  StepResponse response;
  Fleet fleet;
  ObstacleColumns obstacles;
  UniformGrid robot_grid, obstacle_grid;
  std::vector<Worker> workers;
  std::int64_t steps = 0;
  std::uint64_t next_id = 0;
  bool measuring = false;
  StepProfile profile;

  State(const Scenario& scenario, int threads)
      : settings(scenario), planner(planner_options(scenario)), response(step_response(planner)) {
    workers.resize(static_cast<std::size_t>(threads > 0 ? threads : default_threads()));
    for (const RobotSetup& setup : scenario.robots) fleet.add({next_id++}, setup);
    for (const MovingObstacle& obstacle : scenario.moving_obstacles) obstacles.add(obstacle);
    settings.robots.clear();
    settings.moving_obstacles.clear();
    reserve();
    index();
  }

  std::size_t most_neighbors() const {
    const PlannerOptions& options = planner.options();
    // a certificate needs all of them
    return options.max_neighbors && options.certificate == Certificate::none
               ? static_cast<std::size_t>(*options.max_neighbors)
               : std::numeric_limits<std::size_t>::max();
  }
  void reserve() {
    for (Worker& worker : workers) {
      worker.reserve(fleet.size(), obstacles.setup.size(), most_neighbors());
      worker.plan.reserve(worker.neighbors.capacity(), most_braking_steps());
    }
  }
  // of any robot and what it may decide on
  std::size_t most_braking_steps() const {
    if (planner.options().certificate == Certificate::none) return 0;
    constexpr double kMostAhead = 4096.0;  // of more, memory grows when it is needed
    const double braking_time = planner.step_rate() * planner.options().control_time;
    double most = 0.0;
    for (const RobotSetup& setup : fleet.setup) {
      most = std::max(most, setup.max_speed / (setup.max_acceleration * braking_time));
    }
    return static_cast<std::size_t>(std::min(most + 4.0, kMostAhead));
  }
  void index() {
    robot_grid.build(fleet.position, settings.sensing_radius);
    obstacle_grid.build(obstacles.position, settings.sensing_radius);
  }
  // a single robot avoids movers by §III-C; among other robots they are neighbors that do not
  // decide
  bool alone() const { return fleet.size() == 1; }

  void check(const RobotSetup& setup, RobotId robot) const;
  void check_sensing(const RobotSetup& setup, RobotId robot) const;
  Robot robot(std::size_t i) const;
  std::optional<CarSetup> car(std::size_t i) const;
  void sense(std::size_t i, Worker& worker) const;
  void plan(std::size_t i, Worker& worker);
  void move(std::size_t i);
  void count(std::chrono::nanoseconds planning, std::chrono::nanoseconds indexing);
};

// Throws Error on values out of range, by the name of the robot that they are for.
void Simulation::State::check(const RobotSetup& setup, RobotId robot) const {
  Scenario scene = settings;
  scene.robots = {setup};
  const PlannerOptions& options = planner.options();
  try {
    validate(scene);
    // the others count on it to stop as soon as they do
    if (options.certificate == Certificate::linear_soft_stop &&
        setup.max_speed / setup.max_acceleration > options.soft_stop_time) {
      throw Error("robots.0.max_speed: found " + std::to_string(setup.max_speed) +
                  ", must be <= max_acceleration * " + std::to_string(options.soft_stop_time) +
                  " s with certificate linear_soft_stop");
    }
  } catch (const Error& error) {
    const std::string_view what = error.what(), place = "robots.0.";
    if (!what.starts_with(place)) throw;
    throw Error("robot " + std::to_string(robot.value) + ": " +
                std::string(what.substr(place.size())));
  }
}

// With its present heading.
std::optional<CarSetup> Simulation::State::car(std::size_t i) const {
  std::optional<CarSetup> car = fleet.setup[i].car;
  if (car) car->heading = fleet.heading[i];
  return car;
}

// Throws Error if nobody would see this one in time, or it others.
void Simulation::State::check_sensing(const RobotSetup& setup, RobotId robot) const {
  Scenario scene = settings;
  scene.moving_obstacles = obstacles.setup;
  scene.robots = fleet.setup;
  const auto before = sensing_need(scene);
  scene.robots.push_back(setup);
  const auto need = sensing_need(scene);
  if (!need || need->range <= scene.sensing_radius * (1.0 + 1e-9)) return;
  if (before && need->range <= before->range) return;  // that was so without it
  throw Error("robot " + std::to_string(robot.value) + ": found a max_speed of " +
              std::to_string(setup.max_speed) + " m/s, has to be seen from " +
              std::to_string(need->range) + " m, sensing_radius is " +
              std::to_string(scene.sensing_radius) + " m");
}

Robot Simulation::State::robot(std::size_t i) const {
  const RobotSetup& setup = fleet.setup[i];
  return {fleet.position[i],
          fleet.velocity[i],
          preferred_velocity(fleet.position[i], fleet.velocity[i], setup, fleet.goal[i], planner),
          setup.radius,
          setup.max_acceleration,
          setup.max_speed,
          norm(fleet.goal[i] - fleet.position[i]),
          car(i)};
}

// All robots and moving obstacles within the sensing radius, nearest first (robots first and by id
// where distances are equal), cut to the nearest max_neighbors.
void Simulation::State::sense(std::size_t i, Worker& worker) const {
  const std::size_t most = most_neighbors();
  robot_grid.gather(fleet.position[i], static_cast<int>(i), most, worker.robots);
  obstacle_grid.gather(fleet.position[i], -1, most, worker.obstacles);
  worker.neighbors.clear();
  worker.source.clear();
  auto robot = worker.robots.begin();
  auto obstacle = worker.obstacles.begin();
  while (worker.neighbors.size() < most) {
    const bool more_robots = robot != worker.robots.end();
    const bool more_obstacles = obstacle != worker.obstacles.end();
    if (!more_robots && !more_obstacles) break;
    if (more_robots && (!more_obstacles || robot->distance_squared <= obstacle->distance_squared)) {
      const auto j = static_cast<std::size_t>(robot->index);
      const RobotSetup& setup = fleet.setup[j];
      worker.neighbors.push_back(
          {fleet.position[j], fleet.velocity[j], setup.radius, setup.max_acceleration, {}});
      worker.source.push_back(robot->index);
      ++robot;
    } else {
      const auto k = static_cast<std::size_t>(obstacle->index);
      const MovingObstacle& setup = obstacles.setup[k];
      worker.neighbors.push_back(
          {obstacles.position[k], obstacles.velocity[k], setup.radius, 0.0, setup.acceleration});
      worker.source.push_back(-1 - obstacle->index);
      ++obstacle;
    }
  }
}

void Simulation::State::plan(std::size_t i, Worker& worker) {
  sense(i, worker);
  fleet.plan[i] = alone() ? planner.plan_among_obstacles(robot(i), worker.neighbors, worker.plan)
                          : planner.plan(robot(i), worker.neighbors, worker.plan, fleet.detour[i]);
}

void Simulation::State::move(std::size_t i) {
  const MotionState state{fleet.position[i], fleet.velocity[i], fleet.heading[i]};
  const MotionStep step =
      fleet.setup[i].car ? advance_car(state, fleet.plan[i],
                                       {fleet.setup[i].car->wheelbase,
                                        fleet.setup[i].max_acceleration, fleet.setup[i].max_speed},
                                       settings.time_step)
                         : advance(state, fleet.plan[i], response);
  fleet.next_position[i] = step.next.position;
  fleet.next_velocity[i] = step.next.velocity;
  fleet.next_heading[i] = step.next.heading;
  fleet.applied_acceleration[i] = step.acceleration;
}

Simulation::Simulation(const Scenario& scenario, int threads) {
  validate(scenario);
  if (threads < 0) {
    throw Error("threads: found " + std::to_string(threads) + ", must be >= 0 (0: all there are)");
  }
  state_ = std::make_unique<State>(scenario, threads);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step() {
  State& state = *state_;
  const auto start = std::chrono::steady_clock::now();
  parallel_for(state.fleet.size(), static_cast<int>(state.workers.size()),
               [&](std::size_t i, std::size_t worker) {
                 state.plan(i, state.workers[worker]);
                 state.move(i);
               });
  state.fleet.swap_generations();
  state.obstacles.advance(state.settings.time_step);
  ++state.steps;
  const auto planned = std::chrono::steady_clock::now();
  state.index();
  if (state.measuring) state.count(planned - start, std::chrono::steady_clock::now() - planned);
}

RobotId Simulation::add_robot(const RobotSetup& setup) {
  const RobotId robot{state_->next_id};
  state_->check(setup, robot);
  state_->check_sensing(setup, robot);
  ++state_->next_id;
  state_->fleet.add(robot, setup);
  state_->index();
  return robot;
}

void Simulation::remove_robot(RobotId robot) {
  state_->fleet.remove(state_->fleet.index_of(robot));
  state_->index();
}

void Simulation::set_goal(RobotId robot, Vec2 goal) {
  const std::size_t i = state_->fleet.index_of(robot);
  RobotSetup setup = state_->fleet.setup[i];
  setup.goal = goal;
  state_->check(setup, robot);
  state_->fleet.goal[i] = goal;
}

FleetView Simulation::fleet() const {
  const Fleet& f = state_->fleet;
  return {f.id,      f.position, f.velocity,
          f.heading, f.goal,     f.setup,
          f.detour,  f.plan,     f.applied_acceleration};
}

ObstacleView Simulation::obstacles() const {
  const ObstacleColumns& o = state_->obstacles;
  return {o.position, o.velocity, o.setup};
}

double Simulation::time() const {
  return static_cast<double>(state_->steps) * state_->settings.time_step;
}

std::int64_t Simulation::steps() const {
  return state_->steps;
}

bool Simulation::all_at_goal() const {
  const Fleet& f = state_->fleet;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (!(norm(f.goal[i] - f.position[i]) <= state_->settings.arrival_distance)) return false;
  }
  return true;
}

std::uint64_t Simulation::state_hash() const {
  return hash_of(state_->fleet, state_->obstacles, state_->steps);
}

Simulation::Perception Simulation::perceive(std::size_t robot) const {
  Worker worker;
  state_->sense(robot, worker);
  return {state_->robot(robot), std::move(worker.neighbors), std::move(worker.source),
          state_->fleet.detour[robot], state_->alone()};
}

const Planner& Simulation::planner() const {
  return state_->planner;
}

// The pairs are those of the generation just made.
void Simulation::State::count(std::chrono::nanoseconds planning,
                              std::chrono::nanoseconds indexing) {
  profile.robot_steps += static_cast<std::int64_t>(fleet.size());
  const int most = planner.options().max_neighbors.value_or(std::numeric_limits<int>::max());
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    sense(i, workers[0]);
    profile.pairs += std::min<std::int64_t>(most, std::ssize(workers[0].neighbors));
    profile.infeasible += fleet.plan[i].violation > 0.0 ? 1 : 0;
  }
  profile.stages[0].nanoseconds += static_cast<double>(planning.count());
  profile.stages[1].nanoseconds += static_cast<double>(indexing.count());
}

void Simulation::measure(bool on) {
  state_->measuring = on;
  state_->profile = {};
  state_->profile.stages = {{"plan", 0.0}, {"index", 0.0}};
}

StepProfile Simulation::profile() const {
  return state_->profile;
}

int Simulation::threads() const {
  return static_cast<int>(state_->workers.size());
}

}  // namespace avo
