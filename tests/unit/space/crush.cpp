// SPDX-License-Identifier: Apache-2.0
#include "unit/space/crush.h"

#include <algorithm>

#include "space/certificate.h"
#include "space/own_space.h"
#include "space/step_law.h"

namespace avo::space::tests {

std::vector<CheckedRobot> bodies_of(std::span<const Robot> robots) {
  std::vector<CheckedRobot> bodies;
  for (const Robot& robot : robots)
    bodies.push_back({.radius = robot.radius,
                      .downwash = robot.downwash,
                      .max_acceleration = robot.max_acceleration,
                      .max_speed = robot.max_speed,
                      .vertical = robot.vertical,
                      .max_braking = robot.max_braking});
  return bodies;
}

Crush::Crush(std::vector<Robot> robots, std::vector<Box> boxes, const PlannerOptions& options,
             Draws draws, int most_age)
    : robots_(std::move(robots)),
      most_age_(most_age),
      boxes_(std::move(boxes)),
      draws_(draws),
      planner_(options),
      horizon_(options.control_time, options.time_horizon, options.time_step),
      check_(bodies_of(robots_), boxes_, CheckOptions{.relative_tolerance = 1e-12}) {
  observe();
}

Neighbor Crush::sensed(std::size_t k) {
  const SensingError& error = planner_.options().sensing_error;
  const int age =
      most_age_ > 0 ? std::min(draws_.below(most_age_ + 1), static_cast<int>(past_.size())) : 0;
  const Robot& seen = age > 0 ? past_[past_.size() - static_cast<std::size_t>(age)][k] : robots_[k];
  Neighbor neighbor = neighbor_of(seen);
  neighbor.age = age;
  neighbor.position = neighbor.position + draws_.within(error.position);
  neighbor.velocity = neighbor.velocity + draws_.within(error.velocity);
  neighbor.position = neighbor.position + (age * planner_.options().time_step) * neighbor.velocity;
  return neighbor;
}

// A robot that takes itself to be elsewhere sees boxes elsewhere.
std::vector<Box> Crush::seen_boxes() {
  const double lost = planner_.options().localization_error;
  if (!(lost > 0.0)) return boxes_;
  const Vec3 off = draws_.below(2) == 0 ? lost * draws_.direction() : draws_.within(lost);
  std::vector<Box> boxes;
  for (const Box& box : boxes_) boxes.push_back(moved(box, off));
  return boxes;
}

Vec3 towards(const Robot& robot, Vec3 direction, double time_step) {
  const double u = robot.max_acceleration * time_step;
  const Vec3 own = to_own(direction, robot.vertical);
  Vec3 v = to_own(robot.velocity, robot.vertical) + ((1.0 - 1e-12) * u / norm(own)) * own;
  const double speed = norm(v);
  if (speed > robot.max_speed) v = ((1.0 - 1e-12) * robot.max_speed / speed) * v;
  return from_own(v, robot.vertical);
}

// The worst of some velocities that is admitted: towards others, or anywhere.
Vec3 Crush::choose(std::size_t k) {
  const Robot& robot = robots_[k];
  std::vector<Neighbor> others;
  for (std::size_t j = 0; j < robots_.size(); ++j) {
    if (j != k) others.push_back(sensed(j));
  }
  const std::vector<Box> boxes = seen_boxes();
  const Vec3 backup = backup_velocity(robot, step_law(planner_.options(), horizon_));
  for (int attempt = 0; attempt < 6; ++attempt) {
    Vec3 to = draws_.direction();
    if (attempt < 4) {
      const auto at = static_cast<std::size_t>(draws_.below(static_cast<int>(robots_.size())));
      if (at == k) continue;
      to = robots_[at].position - robot.position + 0.3 * draws_.direction();
      if (!boxes_.empty() && attempt % 2 == 0) {
        const auto box = static_cast<std::size_t>(draws_.below(static_cast<int>(boxes_.size())));
        to = nearest(robot.position, robot.position, boxes_[box]).on_box - robot.position;
      }
    }
    Vec3 v = towards(robot, to, planner_.options().time_step);
    // as near to what is refused as the certificate lets it
    for (int halving = 0; halving < 5; ++halving) {
      if (planner_.is_admitted(robot, others, workspace_, v, boxes)) return v;
      v = 0.5 * (v + backup);
    }
  }
  return backup;
}

void Crush::step() {
  std::vector<Vec3> next;
  for (std::size_t k = 0; k < robots_.size(); ++k) next.push_back(choose(k));
  past_.push_back(robots_);
  const double h = planner_.options().time_step;
  for (std::size_t k = 0; k < robots_.size(); ++k) {
    Robot& robot = robots_[k];
    robot.position = robot.position + (0.5 * h) * (robot.velocity + next[k]);
    robot.velocity = next[k];
  }
  time_ += h;
  observe();
}

void Crush::observe() {
  std::vector<CheckedState> rows;
  for (std::size_t k = 0; k < robots_.size(); ++k)
    rows.push_back({static_cast<std::int64_t>(k), robots_[k].position, robots_[k].velocity});
  check_.add(time_, rows);
}

}  // namespace avo::space::tests
