// SPDX-License-Identifier: Apache-2.0
// Robots of a simulation, and robots for a planner.
#include "convert.h"

namespace avo_c {
namespace {

std::optional<avo::LoiterCircle> circle_of(const avo_loiter_circle& circle) {
  if (circle.radius == 0.0) return std::nullopt;
  return avo::LoiterCircle{from_c(circle.center), circle.radius};
}

std::optional<avo::Method> own_method(std::int32_t method, const Where& where) {
  if (method == AVO_UNSET) return std::nullopt;
  return word<avo::Method>(method, 7, where, "method");
}

}  // namespace

avo::RobotSetup setup_of(const avo_robot_def& def, const Where& where) {
  return {.position = from_c(def.position),
          .velocity = from_c(def.velocity),
          .goal = from_c(def.goal),
          .radius = def.radius,
          .max_speed = def.max_speed,
          .max_acceleration = def.max_acceleration,
          .preferred_speed = def.preferred_speed,
          .model = model_of(def, where),
          .heading = def.heading,
          .priority = def.priority,
          .parked = def.parked,
          .layers = {def.layers},
          .avoids = {def.avoids},
          .time_step = unless_zero(def.time_step),
          .max_braking = unless_zero(def.max_braking),
          .behavior = word<avo::Behavior>(def.behavior, 3, where, "behavior"),
          .method = own_method(def.method, where),
          .time_horizon = unless_zero(def.time_horizon)};
}

avo_robot_def def_of(const avo::RobotSetup& setup) {
  avo_robot_def def = {};
  def.size = sizeof def;
  def.position = to_c(setup.position);
  def.velocity = to_c(setup.velocity);
  def.goal = to_c(setup.goal);
  def.radius = setup.radius;
  def.max_speed = setup.max_speed;
  def.max_acceleration = setup.max_acceleration;
  def.preferred_speed = setup.preferred_speed;
  set_model(setup.model, def);
  def.heading = setup.heading;
  def.priority = setup.priority;
  def.parked = setup.parked;
  def.layers = setup.layers.bits;
  def.avoids = setup.avoids.bits;
  def.time_step = setup.time_step.value_or(0.0);
  def.max_braking = setup.max_braking.value_or(0.0);
  def.behavior = static_cast<avo_behavior>(setup.behavior);
  def.method = setup.method ? static_cast<std::int32_t>(*setup.method) : AVO_UNSET;
  def.time_horizon = setup.time_horizon.value_or(0.0);
  return def;
}

avo::Robot robot_of(const avo_robot& robot) {
  return {.position = from_c(robot.position),
          .velocity = from_c(robot.velocity),
          .preferred_velocity = from_c(robot.preferred_velocity),
          .radius = robot.radius,
          .max_acceleration = robot.max_acceleration,
          .max_speed = robot.max_speed,
          .distance_to_goal = robot.distance_to_goal,
          .model = model_of(robot, {"robot"}),
          .heading = robot.heading,
          .priority = robot.priority,
          .max_braking = unless_zero(robot.max_braking),
          .loiter = circle_of(robot.loiter)};
}

avo::Neighbor neighbor_of(const avo_neighbor& neighbor, const Where& where) {
  return {.position = from_c(neighbor.position),
          .velocity = from_c(neighbor.velocity),
          .radius = neighbor.radius,
          .max_acceleration = neighbor.max_acceleration,
          .behavior = word<avo::Behavior>(neighbor.behavior, 3, where, "behavior"),
          .age = neighbor.age,
          .priority = neighbor.priority,
          .max_braking = unless_zero(neighbor.max_braking),
          .loiter = circle_of(neighbor.loiter),
          .max_deviation = neighbor.max_deviation,
          .position_error = neighbor.position_error,
          .acceleration = from_c(neighbor.acceleration),
          .max_speed = neighbor.max_speed,
          .likely_deviation = neighbor.likely_deviation,
          .parting = from_c(neighbor.parting),
          .trajectory = trajectory_of(neighbor.trajectory),
          .trajectory_time = neighbor.trajectory_time};
}

}  // namespace avo_c

avo_robot_def avo_default_robot_def(void) {
  return avo_c::def_of({});
}

avo_robot avo_default_robot(void) {
  const avo::Robot usual;
  avo_robot robot = {};
  robot.size = sizeof robot;
  robot.radius = usual.radius;
  robot.max_acceleration = usual.max_acceleration;
  robot.max_speed = usual.max_speed;
  robot.distance_to_goal = usual.distance_to_goal;
  robot.priority = usual.priority;
  avo_c::set_model(usual.model, robot);
  return robot;
}

avo_neighbor avo_default_neighbor(void) {
  const avo::Neighbor usual;
  avo_neighbor neighbor = {};
  neighbor.size = sizeof neighbor;
  neighbor.radius = usual.radius;
  neighbor.max_acceleration = usual.max_acceleration;
  neighbor.priority = usual.priority;
  neighbor.max_speed = usual.max_speed;
  return neighbor;
}

avo_vec2 avo_parting_direction(uint64_t id, uint64_t other) {
  const avo::Vec2 direction = avo::parting_direction(id, other);
  return {direction.x, direction.y};
}
