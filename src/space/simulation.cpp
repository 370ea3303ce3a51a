// SPDX-License-Identifier: Apache-2.0
#include "avo/space/simulation.h"

#include <algorithm>
#include <limits>
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
#include "space/routes/tighten.h"
#include "space/routes/ways.h"
#include "space/step_law.h"

namespace avo::space {
namespace {

constexpr std::size_t kTile = 16;  // robots that one task decides for

}  // namespace

/// The memory of a worker.
struct AVO_LOCAL SpaceWorker {
  PlanWorkspace workspace;
  WayScratch ways;
  std::vector<std::uint32_t> found;
  std::vector<Neighbor> neighbors;
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
  std::vector<Robot> robots;
  std::vector<Detour> detours;
  std::vector<Plan> plans;
  std::vector<double> box_range;  // m, of each robot
  SpaceWays ways;
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
        detours(scene.robots.size()),
        plans(scene.robots.size()),
        workers(executor->workers()) {
    for (const RobotSetup& setup : scene.robots) {
      robots.push_back(robot_of(setup));
      box_range.push_back(space::box_range(robots.back(), planner.options()));
    }
    ways = SpaceWays(scene.boxes, robots, goals(), scene.navigation);
  }

  [[nodiscard]] std::vector<Vec3> goals() const {
    std::vector<Vec3> all;
    for (const RobotSetup& setup : scenario.robots) all.push_back(setup.goal);
    return all;
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
    for (const std::uint32_t other : worker.found)
      worker.neighbors.push_back(neighbor_of(robots[other]));
    worker.boxes.clear();
    for (const Box& box : scenario.boxes) {
      if (nearest(place, place, box).distance - box.radius <= box_range[k])
        worker.boxes.push_back(box);
    }
  }

  void decide(std::size_t k, SpaceWorker& worker) {
    sense(k, worker);
    Robot& robot = robots[k];
    const RobotSetup& setup = scenario.robots[k];
    const Company company{worker.neighbors, detours[k].angle, sensing_radius, law.time_step};
    const SpaceHeading heading =
        ways.heading(k, robot, setup.goal, setup.preferred_speed, company, worker.ways);
    robot.distance_to_goal = heading.left;
    robot.preferred_velocity = preferred_velocity(robot, heading.goal, heading.speed, landing);
    plans[k] = planner.plan(robot, worker.neighbors, worker.workspace, &detours[k], worker.boxes);
  }

  /// Calls visit(robot, worker) for all robots, in parallel where they are many.
  template <typename Visit>
  void for_all(const Visit& visit) {
    const std::size_t count = robots.size(), tiles = (count + kTile - 1) / kTile;
    const auto visit_tile = [&](std::size_t tile, std::size_t worker) {
      const std::size_t end = std::min((tile + 1) * kTile, count);
      for (std::size_t k = tile * kTile; k < end; ++k) visit(k, workers[worker]);
    };
    if (count >= kFewestParallel) return parallel_for(*executor, tiles, visit_tile);
    for (std::size_t tile = 0; tile < tiles; ++tile) visit_tile(tile, 0);
  }

  void find_routes() {
    if (!ways.has_boxes()) return;
    for_all([&](std::size_t k, SpaceWorker& worker) {
      ways.look(k, robots[k], scenario.robots[k].goal, worker.ways);
    });
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
  state_->find_routes();
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step() {
  State& state = *state_;
  state.cells.sort(state.robots);
  state.ways.begin_step(state.robots);
  state.for_all([&](std::size_t k, SpaceWorker& worker) { state.decide(k, worker); });
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
  const Vec3 position = state_->robots[robot].position, to = goal(robot);
  return norm(to - position) <= state_->scenario.arrival_distance &&
         !state_->ways.is_behind_box(robot, position, to);
}

Simulation::Way Simulation::way(std::size_t robot) const {
  const Vec3 position = state_->robots[robot].position, to = goal(robot);
  const Route* route = state_->ways.route(robot);
  if (route == nullptr || route->points.empty()) return {norm(to - position), to, 0.0};
  Way way{route_length(position, route->points), route->points.front().place, route->left};
  if (!route->reaches) way.length = std::numeric_limits<double>::infinity();
  return way;
}

std::vector<std::size_t> Simulation::unreachable() const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < size(); ++k) {
    const Route* route = state_->ways.route(k);
    if (route != nullptr && !route->reaches) found.push_back(k);
  }
  return found;
}

void Simulation::set_goal(std::size_t robot, Vec3 goal) {
  if (robot >= size())
    throw Error("robot " + std::to_string(robot) + ": there are " + std::to_string(size()));
  if (!is_finite(goal)) throw Error("goal: found a number that is not finite");
  Vec3& own = state_->scenario.robots[robot].goal;
  if (own == goal) return;
  own = goal;
  state_->ways.include(goal);
  state_->ways.look(robot, state_->robots[robot], goal, state_->workers.front().ways);
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
  state_->ways.set_boxes(boxes, state_->robots, state_->goals());
  state_->find_routes();
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
