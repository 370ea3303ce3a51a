// SPDX-License-Identifier: Apache-2.0
#include "fleet_loop.h"

#include <algorithm>
#include <cmath>

#include "avo/error.h"

namespace avo::safety {
namespace {

// Returns the fastest velocity w at which a robot still stops at its goal: w²/2a + w Δt fits into
// the remaining distance.
Vec2 towards_goal(const Robot& robot, Vec2 goal, double preferred_speed, const Planner& planner) {
  const Vec2 way = goal - robot.position;
  const double distance = norm(way);
  if (!(distance > 0.0)) return {};
  const Vec2 direction = way / distance;
  const double a = robot.max_acceleration, u = a * planner.options().time_step;
  const double left = std::max(0.0, distance - planner.step_lag() * dot(robot.velocity, direction));
  return std::min(preferred_speed, std::sqrt(u * u + 2.0 * a * left) - u) * direction;
}

PlannerOptions options_of_odd(PlannerOptions options, Oddity oddity) {
  if (oddity == Oddity::half_steps) options.time_step *= 0.5;
  return options;
}

}  // namespace

FleetLoop::FleetLoop(const Scene& scene, std::uint64_t seed, const PlannerOptions& options)
    : setup_(scene.scenario.robots),
      acting_(scene.acting),
      planners_{Planner(options), Planner(options_of_odd(options, scene.acting.oddity))},
      senses_(*scene.sensing, setup_.size(), options.time_step, seed),
      random_(seed, 11),
      tick_time_(options.time_step / static_cast<double>(acting_.ticks)),
      detours_(setup_.size()) {
  if (acting_.ticks > 1 && options.motion != Motion::held) {
    throw Error(std::string("motion: found ") + to_string(options.motion) + ", must be held here");
  }
  for (const RobotSetup& setup : setup_) {
    Robot robot;
    robot.position = setup.position;
    robot.velocity = setup.velocity;
    robot.radius = setup.radius;
    robot.max_acceleration = setup.max_acceleration;
    robot.max_speed = setup.max_speed;
    robots_.push_back(robot);
    drives_.push_back({robot.position, robot.velocity, robot.velocity});
    const bool is_odd = acting_.oddity != Oddity::none && random_.between(0.0, 1.0) < 0.5;
    odd_.push_back(is_odd ? 1 : 0);
    const auto ticks = static_cast<std::size_t>(acting_.ticks);
    next_decision_.push_back(acting_.phases ? static_cast<std::int64_t>(random_.below(ticks)) : 0);
  }
  for (const MovingObstacle& obstacle : scene.scenario.moving_obstacles) {
    obstacles_.push_back({.position = obstacle.position,
                          .velocity = obstacle.velocity,
                          .radius = obstacle.radius,
                          .behavior = Behavior::moves_on,
                          .acceleration = obstacle.acceleration});
  }
  before_ = robots_;
  commands_.resize(robots_.size());
}

std::int64_t FleetLoop::step_ticks(std::size_t i) const {
  const bool is_halved = odd_[i] != 0 && acting_.oddity == Oddity::half_steps;
  return is_halved ? acting_.ticks / 2 : acting_.ticks;
}

void FleetLoop::send_all_to(Vec2 goal) {
  for (RobotSetup& setup : setup_) setup.goal = goal;
}

void FleetLoop::turn_movers() {
  for (Neighbor& obstacle : obstacles_) {
    do {
      obstacle.acceleration = random_.in_square(2.0 * acting_.whims);
    } while (norm(obstacle.acceleration) > acting_.whims);
  }
}

Plan FleetLoop::decide(std::size_t i) {
  Robot& robot = robots_[i];
  const RobotSetup& setup = setup_[i];
  const Planner& planner = this->planner(i);
  robot.preferred_velocity = towards_goal(robot, setup.goal, setup.preferred_speed, planner);
  robot.distance_to_goal = norm(setup.goal - robot.position);
  senses_.observe(i, robots_, before_, ticks_, neighbors_);
  neighbors_.insert(neighbors_.end(), obstacles_.begin(), obstacles_.end());
  const bool is_one_sided = odd_[i] != 0 && acting_.oddity == Oddity::one_sided;
  const Plan plan = is_one_sided ? planner.plan_among_movers(robot, neighbors_, workspace_)
                                 : planner.plan(robot, neighbors_, workspace_, &detours_[i]);
  const Vec2 v = robot.velocity;
  Vec2 v_1 = v + planner.step_rate() * (plan.new_velocity - v);
  if (norm_squared(v_1) < 0x1p-100 * norm_squared(v)) v_1 = {};  // v_1 is zero up to rounding
  commands_[i] = {v_1, ticks_ + acting_.latency};
  const auto spread = static_cast<std::size_t>(2 * acting_.jitter + 1);
  const auto later = acting_.jitter > 0 ? static_cast<std::int64_t>(random_.below(spread)) : 0;
  next_decision_[i] = ticks_ + step_ticks(i) - acting_.jitter + later;
  return plan;
}

void FleetLoop::follow_commands() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (commands_[i].at != ticks_) continue;
    const Robot& robot = robots_[i];
    Vec2 change = commands_[i].next_velocity - robot.velocity;
    const double most = acting_.strength * robot.max_acceleration * planner(i).options().time_step;
    const bool differs = acting_.strength < 1.0 || acting_.latency > 0;  // from the decision
    if (differs && norm(change) > most) change = (most / norm(change)) * change;
    drives_[i] = {robot.position, robot.velocity, robot.velocity + change, ticks_};
    commands_[i].at = kNever;
  }
}

// Moves from v to v_1 by s v + (Δt - s) v_1; held motion: v Δt + a Δt²/2.
void FleetLoop::move(std::size_t i) {
  const Drive& drive = drives_[i];
  Robot& robot = robots_[i];
  const Vec2 v = drive.velocity, v_1 = drive.next_velocity;
  const std::int64_t passed = ticks_ + 1 - drive.since;
  const double lag = planner(i).step_lag(), lead = planner(i).options().time_step - lag;
  const std::int64_t step = step_ticks(i);
  if (passed < step) {
    const double t = static_cast<double>(passed) * tick_time_;
    const double part = static_cast<double>(passed) / static_cast<double>(step);
    robot.position = drive.position + (t * v + (0.5 * t * part) * (v_1 - v));
    robot.velocity = v + part * (v_1 - v);
    return;
  }
  const double after = static_cast<double>(passed - step) * tick_time_;
  robot.position = drive.position + (lag * v + lead * v_1) + after * v_1;
  robot.velocity = v_1;
}

void FleetLoop::tick() {
  follow_commands();
  plans_.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (next_decision_[i] == ticks_) plans_.push_back(decide(i));
  }
  follow_commands();
  before_ = robots_;
  for (std::size_t i = 0; i < robots_.size(); ++i) move(i);
  for (Neighbor& obstacle : obstacles_) {
    const Vec2 v = obstacle.velocity, a = obstacle.acceleration;
    obstacle.position = obstacle.position + tick_time_ * v + (0.5 * tick_time_ * tick_time_) * a;
    obstacle.velocity = v + tick_time_ * a;
  }
  ++ticks_;
}

}  // namespace avo::safety
