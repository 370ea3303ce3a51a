// SPDX-License-Identifier: Apache-2.0
#include "avo/space/simulation.h"

#include <algorithm>
#include <string>
#include <vector>

#include "avo/error.h"
#include "core/executor.h"
#include "core/hash.h"
#include "core/response_law.h"
#include "space/bodies.h"
#include "space/cells.h"
#include "space/certificate.h"
#include "space/decide.h"
#include "space/goals.h"
#include "space/own_space.h"
#include "space/senses.h"
#include "space/step_law.h"
#include "space/validity.h"
#include "space/workspace.h"

namespace avo::space {
namespace {

constexpr std::size_t kTile = 16;  // robots that one task decides for

}  // namespace

/// The memory of a worker.
struct AVO_LOCAL SpaceWorker {
  PlanWorkspace::Scratch scratch;
  SpaceCells::Runs runs{};
  std::vector<Box> boxes;
  std::vector<Mover> movers;
};

/// What a robot's scene says of its way; near in memory, unlike the scene.
struct AVO_LOCAL Way {
  Vec3 goal;               // m
  double preferred_speed;  // m/s
  double box_range;        // m
};

struct Simulation::State {
  Scenario scenario;
  PlannerOptions options;
  Horizon horizon;
  StepLaw law;
  Landing landing;
  double sensing_radius;
  std::shared_ptr<Executor> executor;
  SpaceCells cells;
  Bodies bodies;  // the robots in the order of the cells
  Senses senses;
  std::vector<Mover> movers;  // as they are now
  std::vector<Robot> robots;
  std::vector<Detour> detours;
  std::vector<Plan> plans;
  std::vector<Way> ways;
  std::vector<SpaceWorker> workers;
  std::int64_t steps = 0;

  State(const Scenario& scene, int threads)
      : scenario(scene),
        options(planner_options(scene)),
        horizon(options.control_time, options.time_horizon, options.time_step),
        law(step_law(options, horizon)),
        landing{response_law(options), law.lag, law.braking_time},
        sensing_radius(sensing_radius_of(scene)),
        executor(make_executor(static_cast<std::size_t>(std::max(threads, 0)))),
        cells(sensing_radius),
        senses(senses_of(scene)),
        detours(scene.robots.size()),
        plans(scene.robots.size()),
        workers(executor->workers()) {
    validate_in_space(options);
    for (const RobotSetup& setup : scene.robots) {
      robots.push_back(robot_of(setup));
      const double range = space::box_range(robots.back(), options);
      ways.push_back(
          {setup.goal, setup.preferred_speed,
           scene.moving_obstacles.empty() ? range : std::max(range, options.wall_range)});
    }
    move_obstacles();
    bodies.reserve(robots.size());
  }

  void sort() {
    cells.sort(robots);
    bodies.clear();
    for (const std::uint32_t k : cells.order()) bodies.add(neighbor_of(robots[k]), k);
    fill_braking(law, bodies);
  }

  void move_obstacles() {
    movers.clear();
    const double now = static_cast<double>(steps) * scenario.time_step;
    for (const MovingObstacle& obstacle : scenario.moving_obstacles)
      movers.push_back(mover_at(obstacle, now));
  }

  [[nodiscard]] bool is_in_range(Vec3 place, std::size_t k) const {
    return norm_squared(place - robots[k].position) <= sensing_radius * sensing_radius;
  }

  /// The moving obstacles that a robot senses.
  void sense_movers(std::size_t k, SpaceWorker& worker) const {
    worker.movers.clear();
    if (movers.empty()) return;
    const Observer observer(senses, k, scenario.boxes);
    for (std::size_t m = 0; m < movers.size(); ++m) {
      if (!is_in_range(movers[m].position, k)) continue;
      if (senses.are_exact()) {
        worker.movers.push_back(movers[m]);
      } else if (const auto seen = observer.look_at(m, scenario.moving_obstacles[m])) {
        worker.movers.push_back(*seen);
      }
    }
  }

  /// The robots that a robot senses by measurements, in the memory of the worker.
  void sense_robots(std::size_t k, std::size_t runs, SpaceWorker& worker) const {
    Bodies& seen = worker.scratch.bodies;
    seen.clear();
    const Observer observer(senses, k, scenario.boxes);
    for (const Run& run : std::span(worker.runs).first(runs)) {
      seen.reserve(seen.count + (run.last - run.first));
      for (std::size_t place = run.first; place < run.last; ++place) {
        const std::size_t other = cells.order()[place];
        if (other == k || !is_in_range(robots[other].position, k)) continue;
        if (const auto neighbor = observer.look_at(other, robots[other]))
          seen.add(*neighbor, other);
      }
    }
    fill_braking(law, seen);
  }

  void find_boxes(std::size_t k, SpaceWorker& worker) const {
    const Vec3 place = robots[k].position;
    worker.boxes.clear();
    for (const Box& box : scenario.boxes) {
      if (nearest(place, place, box).distance - box.radius <= ways[k].box_range)
        worker.boxes.push_back(box);
    }
  }

  /// Decides for the robot at that place in the order of the cells.
  void decide(std::size_t at, SpaceWorker& worker) {
    const std::size_t k = cells.order()[at];
    Robot& robot = robots[k];
    const Way& way = ways[k];
    robot.distance_to_goal = norm(way.goal - robot.position);
    robot.preferred_velocity = preferred_velocity(robot, way.goal, way.preferred_speed, landing);
    find_boxes(k, worker);
    const std::size_t runs = cells.around(robot.position, worker.runs);
    sense_movers(k, worker);
    const auto decide = [&](const Surroundings& around) {
      plans[k] =
          space::decide(options, horizon, law, robot, around, true, worker.scratch, detours[k]);
    };
    if (senses.are_exact())
      return decide({.bodies = bodies,
                     .runs = std::span(worker.runs).first(runs),
                     .self = static_cast<double>(at),
                     .range = sensing_radius,
                     .boxes = worker.boxes,
                     .movers = worker.movers,
                     .is_free = plans[k].status == PlanStatus::optimal});
    sense_robots(k, runs, worker);
    const Run all{0, worker.scratch.bodies.count};
    decide({.bodies = worker.scratch.bodies,
            .runs = std::span(&all, 1),
            .boxes = worker.boxes,
            .movers = worker.movers});
  }

  void move() {
    for (std::size_t k = 0; k < robots.size(); ++k) {
      Robot& robot = robots[k];
      const Vec3 next = plans[k].next_velocity;
      robot.position =
          robot.position + (law.lag * robot.velocity + (law.time_step - law.lag) * next);
      robot.velocity = next;
    }
  }
};

Simulation::Simulation(const Scenario& scenario, int threads) {
  validate(scenario);
  state_ = std::make_unique<State>(scenario, threads);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step() {
  State& state = *state_;
  state.sort();
  state.senses.note(state.robots, state.steps);
  const std::size_t count = state.robots.size();
  const auto decide = [&](std::size_t tile, std::size_t worker) {
    const std::size_t end = std::min((tile + 1) * kTile, count);
    for (std::size_t at = tile * kTile; at < end; ++at) state.decide(at, state.workers[worker]);
  };
  const std::size_t tiles = (count + kTile - 1) / kTile;
  if (count < kFewestParallel) {
    for (std::size_t tile = 0; tile < tiles; ++tile) decide(tile, 0);
  } else {
    parallel_for(*state.executor, tiles, decide);
  }
  state.move();
  ++state.steps;
  state.move_obstacles();
}

double Simulation::time() const {
  return static_cast<double>(state_->steps) * state_->scenario.time_step;
}
std::int64_t Simulation::steps() const {
  return state_->steps;
}
std::size_t Simulation::size() const {
  return state_->robots.size();
}
const Scenario& Simulation::scenario() const {
  return state_->scenario;
}
std::span<const Robot> Simulation::robots() const {
  return state_->robots;
}
std::span<const Plan> Simulation::plans() const {
  return state_->plans;
}
std::span<const Mover> Simulation::movers() const {
  return state_->movers;
}
Vec3 Simulation::goal(std::size_t robot) const {
  return state_->scenario.robots[robot].goal;
}
bool Simulation::is_at_goal(std::size_t robot) const {
  return norm(goal(robot) - state_->robots[robot].position) <= state_->scenario.arrival_distance;
}

void Simulation::set_goal(std::size_t robot, Vec3 goal) {
  if (robot >= size())
    throw Error("robot " + std::to_string(robot) + ": there are " + std::to_string(size()));
  if (!is_finite(goal)) throw Error("goal: found a number that is not finite");
  Vec3& own = state_->scenario.robots[robot].goal;
  if (own == goal) return;
  own = state_->ways[robot].goal = goal;
  Detour& detour = state_->detours[robot];
  detour = {.congestion = detour.congestion, .acceleration = detour.acceleration};
}

void Simulation::set_boxes(std::span<const Box> boxes) {
  BoxConstraints constraints;
  for (std::size_t k = 0; k < size(); ++k) {
    begin_boxes(state_->robots[k], boxes, state_->law, constraints);
    if (constraints.tight.any())
      throw Error("box " + std::to_string(constraints.tight.index) + ": robot " +
                  std::to_string(k) + " is in it, or cannot brake before it");
  }
  state_->scenario.boxes.assign(boxes.begin(), boxes.end());
  state_->scenario.obstacle_of_box.clear();
}

std::uint64_t Simulation::state_hash() const {
  std::uint64_t hash = static_cast<std::uint64_t>(state_->steps);
  for (const Robot& robot : state_->robots) {
    for (const double x : {robot.position.x, robot.position.y, robot.position.z, robot.velocity.x,
                           robot.velocity.y, robot.velocity.z})
      hash = mixed(hash, word_of(x));
  }
  return hash;
}

}  // namespace avo::space
