// SPDX-License-Identifier: Apache-2.0
#include "avo/space/simulation.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo/space/explanation.h"
#include "core/hash.h"
#include "core/ranges.h"
#include "space/boxes.h"
#include "space/fleet.h"
#include "space/mover_edits.h"
#include "space/routes/tighten.h"
#include "space/validity.h"
#include "space/words.h"

namespace avo::space {

struct Simulation::State : SpaceFleet {
  using SpaceFleet::SpaceFleet;

  // The robot's place in the fleet, which is the value of its id.
  [[nodiscard]] std::size_t find(RobotId robot) const {
    if (robot.value >= robots.size())
      throw Error("robot " + std::to_string(robot.value) + ": found none of that id");
    return static_cast<std::size_t>(robot.value);
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
  state_->step();
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
std::optional<Simulation::Touched> Simulation::touched(RobotId robot) const {
  const std::size_t k = state_->find(robot);
  if (state_->plans[k].status != PlanStatus::overlapping) return std::nullopt;
  return state_->touched[k];
}
std::span<const Mover> Simulation::movers() const {
  return state_->movers.now;
}
std::span<const MovingObstacleId> Simulation::moving_obstacle_ids() const {
  return state_->movers.id;
}
std::span<const MoverState> Simulation::movers_before() const {
  return state_->movers.before;
}
Vec3 Simulation::goal(RobotId robot) const {
  return state_->scenario.robots[state_->find(robot)].goal;
}
bool Simulation::is_at_goal(RobotId robot) const {
  const std::size_t k = state_->find(robot);
  const Vec3 position = state_->robots[k].position, to = goal(robot);
  const bool is_there = norm(to - position) <= state_->scenario.arrival_distance &&
                        !state_->routes.is_behind_box(k, position, to);
  return is_there || state_->rests_at_place(k);
}

bool Simulation::all_at_goal() const {
  for (std::size_t k = 0; k < size(); ++k)
    if (!is_at_goal({k})) return false;
  return true;
}

bool Simulation::can_step_by(double time) const {
  constexpr double kOfQuotient = 1e-12;  // of a quotient of decimal fractions
  const double steps = std::floor(time / state_->scenario.time_step * (1.0 + kOfQuotient));
  return static_cast<double>(state_->steps) < steps;
}

Simulation::Route Simulation::route(RobotId robot) const {
  const std::size_t k = state_->find(robot);
  const Vec3 position = state_->robots[k].position, to = goal(robot);
  const SpaceRoute* known = state_->routes.route(k);
  if (known == nullptr || known->points.empty()) return {norm(to - position), to, 0.0};
  Route rest{route_length(position, known->points), known->points.front().place, known->left};
  if (!known->reaches) rest.length = std::numeric_limits<double>::infinity();
  return rest;
}

std::vector<RobotId> Simulation::unreachable() const {
  std::vector<RobotId> found;
  for (std::size_t k = 0; k < size(); ++k) {
    const SpaceRoute* known = state_->routes.route(k);
    if (known != nullptr && !known->reaches) found.push_back({k});
  }
  return found;
}

Simulation::Perception Simulation::perceive(RobotId robot) const {
  return state_->perceive(state_->find(robot));
}

Explanation Simulation::explain(RobotId robot) const {
  Explanation explanation{.robot = robot,
                          .time = time(),
                          .goal = goal(robot),
                          .is_at_goal = is_at_goal(robot),
                          .distance_left = route(robot).distance_left,
                          .seen = perceive(robot)};
  explain_decision(Planner(state_->options), explanation);
  return explanation;
}

void Simulation::set_goal(RobotId robot, Vec3 goal) {
  const std::size_t k = state_->find(robot);
  require("goal", goal, "m");
  Vec3& own = state_->scenario.robots[k].goal;
  if (own == goal) return;
  own = state_->trips[k].goal = goal;
  state_->has_new_goals = true;
  state_->has_stood[k] = 0;
  state_->routes.include(goal);
  state_->routes.look(k, state_->robots[k], goal, state_->workers.front().routes);
  Detour& detour = state_->detours[k];
  detour = {.congestion = detour.congestion, .acceleration = detour.acceleration};
}

MovingObstacleId Simulation::add_moving_obstacle(const MovingObstacle& obstacle) {
  return space::add_moving_obstacle(*state_, obstacle);
}
void Simulation::change_moving_obstacle(MovingObstacleId id, const MovingObstacle& obstacle) {
  space::change_moving_obstacle(*state_, id, obstacle);
}
void Simulation::remove_moving_obstacle(MovingObstacleId id) {
  space::remove_moving_obstacle(*state_, id);
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
  state_->solids = Solids(state_->scenario.boxes);
  state_->scenario.obstacle_of_box.clear();
  state_->routes.set_boxes(state_->scenario.boxes, state_->robots, state_->goals());
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
