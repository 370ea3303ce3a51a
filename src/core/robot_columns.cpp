// SPDX-License-Identifier: Apache-2.0
#include "core/robot_columns.h"

#include <utility>

#include "core/plane.h"

namespace avo::inline core {
namespace {

template <typename Columns, typename Action>
void for_each_column(Columns& robots, const Action& action) {
  for (auto* column :
       {&robots.x, &robots.y, &robots.v_x, &robots.v_y, &robots.preferred_x, &robots.preferred_y,
        &robots.distance_to_goal, &robots.radius, &robots.max_acceleration, &robots.max_speed,
        &robots.max_braking, &robots.priority, &robots.heading}) {
    action(*column);
  }
}

}  // namespace

void RobotColumns::reserve(std::size_t robots) {
  neighbors.reserve(robots);
  model.reserve(robots);
  if (heading.size() >= robots + kSpareNeighbors) return;  // this column grows last
  for_each_column(*this, [&](Column& column) { column.resize(robots + kSpareNeighbors, 1.0); });
}

void RobotColumns::add(const Robot& robot, const Neighbors& sensed) {
  x[count] = robot.position.x, y[count] = robot.position.y;
  v_x[count] = robot.velocity.x, v_y[count] = robot.velocity.y;
  preferred_x[count] = robot.preferred_velocity.x;
  preferred_y[count] = robot.preferred_velocity.y;
  distance_to_goal[count] = robot.distance_to_goal;
  radius[count] = robot.radius;
  max_acceleration[count] = robot.max_acceleration, max_speed[count] = robot.max_speed;
  max_braking[count] = braking_limit(robot);
  heading[count] = robot.heading;
  model.push_back(is_holonomic(robot.model) ? nullptr : &robot.model);
  has_models = has_models || model.back() != nullptr;
  priority[count] = robot.priority;
  if (robot.loiter) {
    loiter.resize(count, nullptr);
    loiter.push_back(&*robot.loiter);
  }
  if (robot.lookahead != kInfinity) {
    lookahead.resize(count, kInfinity);
    lookahead.push_back(robot.lookahead);
  }
  neighbors.push_back(sensed);
  ++count;
}

Robot RobotColumns::robot(std::size_t i) const {
  Robot robot{.position = position(i),
              .velocity = velocity(i),
              .preferred_velocity = {preferred_x[i], preferred_y[i]},
              .radius = radius[i],
              .max_acceleration = max_acceleration[i],
              .max_speed = max_speed[i],
              .distance_to_goal = distance_to_goal[i],
              .priority = priority[i]};
  if (max_braking[i] != max_acceleration[i]) robot.max_braking = max_braking[i];
  if (model[i] != nullptr) robot.model = *model[i], robot.heading = heading[i];
  if (i < loiter.size() && loiter[i] != nullptr) robot.loiter = *loiter[i];
  if (i < lookahead.size()) robot.lookahead = lookahead[i];
  return robot;
}

void RobotColumns::swap(std::size_t i, std::size_t k) {
  for_each_column(*this, [&](Column& column) { std::swap(column[i], column[k]); });
  std::swap(model[i], model[k]);
  std::swap(neighbors[i], neighbors[k]);
  if (!loiter.empty()) std::swap(loiter[i], loiter[k]);
  if (!lookahead.empty()) std::swap(lookahead[i], lookahead[k]);
}

}  // namespace avo::inline core
