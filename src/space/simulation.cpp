// SPDX-License-Identifier: Apache-2.0
#include "avo/space/simulation.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
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
#include "space/ranges.h"
#include "space/routes/tighten.h"
#include "space/routes/ways.h"
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
  std::vector<std::int32_t> box_number, mover_number;  // in the scene
  WayScratch ways;
  std::vector<Neighbor> neighbors;
};

/// What a robot's scene says of its trip; near in memory, unlike the scene.
struct AVO_LOCAL Trip {
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
  std::vector<Trip> trips;
  SpaceWays ways;
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
      trips.push_back(
          {setup.goal, setup.preferred_speed,
           scene.moving_obstacles.empty() ? range : std::max(range, options.wall_range)});
    }
    move_obstacles();
    bodies.reserve(robots.size());
    ways = SpaceWays(scene.boxes, robots, goals(), scene.navigation);
  }

  [[nodiscard]] std::vector<Vec3> goals() const {
    std::vector<Vec3> all;
    for (const Trip& trip : trips) all.push_back(trip.goal);
    return all;
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
    worker.mover_number.clear();
    if (movers.empty()) return;
    const Observer observer(senses, k, scenario.boxes);
    for (std::size_t m = 0; m < movers.size(); ++m) {
      if (!is_in_range(movers[m].position, k)) continue;
      const std::optional<Mover> seen =
          senses.are_exact() ? movers[m] : observer.look_at(m, scenario.moving_obstacles[m]);
      if (!seen) continue;
      worker.movers.push_back(*seen);
      worker.mover_number.push_back(static_cast<std::int32_t>(m));
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
    worker.box_number.clear();
    for (std::size_t b = 0; b < scenario.boxes.size(); ++b) {
      const Box& box = scenario.boxes[b];
      if (nearest(place, place, box).distance - box.radius > trips[k].box_range) continue;
      worker.boxes.push_back(box);
      worker.box_number.push_back(static_cast<std::int32_t>(b));
    }
  }

  /// Sets the preferred velocity of robot k: along its route, where boxes are in the way.
  void head_for_goal(std::size_t k, const Surroundings& around, SpaceWorker& worker) {
    Robot& robot = robots[k];
    worker.neighbors.clear();
    for (const Run& run : !ways.passages().empty() ? around.runs : std::span<const Run>()) {
      for (std::size_t place = run.first; place < run.last; ++place) {
        const Neighbor other = around.bodies.neighbor(place);
        if (static_cast<double>(place) != around.self && is_in_range(other.position, k))
          worker.neighbors.push_back(other);
      }
    }
    const Company company{worker.neighbors, detours[k].angle, sensing_radius, law.time_step};
    const SpaceHeading heading =
        ways.heading(k, robot, trips[k].goal, trips[k].preferred_speed, company, worker.ways);
    robot.distance_to_goal = heading.left;
    robot.preferred_velocity = preferred_velocity(robot, heading.goal, heading.speed, landing);
  }

  /// Decides for the robot at that place in the order of the cells.
  void decide(std::size_t at, SpaceWorker& worker) {
    const std::size_t k = cells.order()[at];
    find_boxes(k, worker);
    const std::size_t runs = cells.around(robots[k].position, worker.runs);
    sense_movers(k, worker);
    const auto decide = [&](const Surroundings& around) {
      head_for_goal(k, around, worker);
      plans[k] =
          space::decide(options, horizon, law, robots[k], around, true, worker.scratch, detours[k]);
      Plan& plan = plans[k];
      if (plan.box >= 0) plan.box = worker.box_number[static_cast<std::size_t>(plan.box)];
      if (plan.mover >= 0) plan.mover = worker.mover_number[static_cast<std::size_t>(plan.mover)];
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

  /// Calls visit(k, worker) for all k below the number of robots, in parallel where they are many.
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
      ways.look(k, robots[k], trips[k].goal, worker.ways);
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
  state.sort();
  state.senses.note(state.robots, state.steps);
  state.ways.begin_step(state.robots);
  state.for_all([&](std::size_t at, SpaceWorker& worker) { state.decide(at, worker); });
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
int Simulation::threads() const {
  return static_cast<int>(state_->executor->workers());
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
  require_vector("goal", goal, "m");
  Vec3& own = state_->scenario.robots[robot].goal;
  if (own == goal) return;
  own = state_->trips[robot].goal = goal;
  state_->ways.include(goal);
  state_->ways.look(robot, state_->robots[robot], goal, state_->workers.front().ways);
  Detour& detour = state_->detours[robot];
  detour = {.congestion = detour.congestion, .acceleration = detour.acceleration};
}

void Simulation::set_boxes(std::span<const Box> given) {
  std::vector<Box> boxes(given.begin(), given.end());  // they may be a part of the scene's own
  check_boxes(boxes);
  BoxConstraints constraints;
  for (std::size_t k = 0; k < size(); ++k) {
    begin_boxes(state_->robots[k], boxes, state_->law, constraints);
    if (constraints.tight.any())
      throw Error("box " + std::to_string(constraints.tight.index) + ": robot " +
                  std::to_string(k) + " is in it, or cannot brake before it");
  }
  state_->scenario.boxes = std::move(boxes);
  state_->scenario.obstacle_of_box.clear();
  state_->ways.set_boxes(state_->scenario.boxes, state_->robots, state_->goals());
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
