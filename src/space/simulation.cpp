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
        detours(scene.robots.size()),
        plans(scene.robots.size()),
        workers(executor->workers()) {
    validate_in_space(options);
    for (const RobotSetup& setup : scene.robots) {
      robots.push_back(robot_of(setup));
      ways.push_back({setup.goal, setup.preferred_speed, space::box_range(robots.back(), options)});
    }
    bodies.reserve(robots.size());
  }

  void sort() {
    cells.sort(robots);
    bodies.clear();
    for (const std::uint32_t k : cells.order()) bodies.add(neighbor_of(robots[k]), k);
    fill_braking(law, bodies);
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
    const Surroundings around{.bodies = bodies,
                              .runs = std::span(worker.runs).first(runs),
                              .self = static_cast<double>(at),
                              .range = sensing_radius,
                              .boxes = worker.boxes,
                              .is_free = plans[k].status == PlanStatus::optimal};
    plans[k] =
        space::decide(options, horizon, law, robot, around, true, worker.scratch, detours[k]);
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
