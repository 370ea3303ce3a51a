// SPDX-License-Identifier: Apache-2.0
#include "avo/space/simulation.h"

#include <algorithm>
#include <string>
#include <vector>

#include "avo/error.h"
#include "core/executor.h"
#include "core/hash.h"
#include "core/response_law.h"
#include "space/cells.h"
#include "space/certificate.h"
#include "space/goals.h"
#include "space/own_space.h"
#include "space/senses.h"
#include "space/step_law.h"

namespace avo::space {
namespace {

constexpr std::size_t kTile = 16;  // robots that one task decides for

}  // namespace

/// The memory of a worker.
struct AVO_LOCAL SpaceWorker {
  PlanWorkspace workspace;
  std::vector<std::uint32_t> found;
  std::vector<Neighbor> neighbors;
  std::vector<Mover> movers;
  std::vector<Box> boxes;
};

struct Simulation::State {
  Scenario scenario;
  Planner planner;
  StepLaw law;
  Landing landing;
  double sensing_radius;
  std::shared_ptr<Executor> executor;
  SpaceCells cells;
  Senses senses;
  std::vector<Mover> movers;  // as they are now
  std::vector<Robot> robots;
  std::vector<Detour> detours;
  std::vector<Plan> plans;
  std::vector<double> box_range;  // m, of each robot
  std::vector<SpaceWorker> workers;
  std::int64_t steps = 0;

  State(const Scenario& scene, int threads)
      : scenario(scene),
        planner(planner_options(scene)),
        law(step_law(planner.options(), Horizon(planner.options().control_time,
                                                planner.options().time_horizon, scene.time_step))),
        landing{response_law(planner.options()), law.lag, law.braking_time},
        sensing_radius(sensing_radius_of(scene)),
        executor(make_executor(static_cast<std::size_t>(std::max(threads, 0)))),
        cells(sensing_radius),
        senses(senses_of(scene)),
        detours(scene.robots.size()),
        plans(scene.robots.size()),
        workers(executor->workers()) {
    for (const RobotSetup& setup : scene.robots) {
      robots.push_back(robot_of(setup));
      const double range = space::box_range(robots.back(), planner.options());
      box_range.push_back(
          scene.moving_obstacles.empty() ? range : std::max(range, planner.options().wall_range));
    }
    move_obstacles();
  }

  /// A robot's neighbors in the order of their indices, and its boxes.
  void sense(std::size_t k, SpaceWorker& worker) const {
    const Vec3 place = robots[k].position;
    worker.found.clear();
    worker.neighbors.clear();
    cells.collect(place, worker.found);
    std::erase_if(worker.found, [&](std::uint32_t other) {
      return other == k ||
             !(norm_squared(robots[other].position - place) <= sensing_radius * sensing_radius);
    });
    std::sort(worker.found.begin(), worker.found.end());
    append_sensed(k, worker);
    worker.boxes.clear();
    for (const Box& box : scenario.boxes) {
      if (nearest(place, place, box).distance - box.radius <= box_range[k])
        worker.boxes.push_back(box);
    }
  }

  void move_obstacles() {
    movers.clear();
    const double now = static_cast<double>(steps) * scenario.time_step;
    for (const MovingObstacle& obstacle : scenario.moving_obstacles)
      movers.push_back(mover_at(obstacle, now));
  }

  /// The moving obstacles within the sensing radius.
  void sense_movers(std::size_t k, SpaceWorker& worker) const {
    worker.movers.clear();
    if (movers.empty()) return;
    const Observer observer(senses, k, scenario.boxes);
    for (std::size_t m = 0; m < movers.size(); ++m) {
      if (!(norm(movers[m].position - robots[k].position) <= sensing_radius)) continue;
      if (senses.are_exact()) {
        worker.movers.push_back(movers[m]);
      } else if (const auto seen = observer.look_at(m, scenario.moving_obstacles[m])) {
        worker.movers.push_back(*seen);
      }
    }
  }

  /// Of the robots within the sensing radius, those that the robot senses.
  void append_sensed(std::size_t k, SpaceWorker& worker) const {
    if (senses.are_exact()) {
      for (const std::uint32_t other : worker.found)
        worker.neighbors.push_back(neighbor_of(robots[other]));
      return;
    }
    const Observer observer(senses, k, scenario.boxes);
    for (const std::uint32_t other : worker.found) {
      if (const auto seen = observer.look_at(other, robots[other]))
        worker.neighbors.push_back(*seen);
    }
  }

  void decide(std::size_t k, SpaceWorker& worker) {
    sense(k, worker);
    sense_movers(k, worker);
    Robot& robot = robots[k];
    const RobotSetup& setup = scenario.robots[k];
    robot.distance_to_goal = norm(setup.goal - robot.position);
    robot.preferred_velocity =
        preferred_velocity(robot, setup.goal, setup.preferred_speed, landing);
    plans[k] = planner.plan(robot, worker.neighbors, worker.workspace, &detours[k], worker.boxes,
                            worker.movers);
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
  state.cells.sort(state.robots);
  state.senses.note(state.robots, state.steps);
  const std::size_t count = state.robots.size();
  const auto decide = [&](std::size_t tile, std::size_t worker) {
    const std::size_t end = std::min((tile + 1) * kTile, count);
    for (std::size_t k = tile * kTile; k < end; ++k) state.decide(k, state.workers[worker]);
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
  own = goal;
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
