// SPDX-License-Identifier: Apache-2.0
// Robots of a simulation, and robots for a planner.
#include "convert.h"
#include "members.h"

namespace avo_c {
namespace {

std::optional<avo::LoiterCircle> circle_of(const avo_loiter_circle& circle) {
  if (circle.radius == 0.0) return std::nullopt;
  return avo::LoiterCircle{from_c(circle.center), circle.radius};
}

// The members of a definition and of a setup, except for the model.
constexpr auto for_each_member = [](const auto& visit) {
  using Def = avo_robot_def;
  using Setup = avo::RobotSetup;
  visit("heading", &Def::heading, &Setup::heading);
  // scripts/fields: members of RobotSetup
  visit("position", &Def::position, &Setup::position);
  visit("velocity", &Def::velocity, &Setup::velocity);
  visit("goal", &Def::goal, &Setup::goal);
  visit("radius", &Def::radius, &Setup::radius);
  visit("max_speed", &Def::max_speed, &Setup::max_speed);
  visit("max_acceleration", &Def::max_acceleration, &Setup::max_acceleration);
  visit("preferred_speed", &Def::preferred_speed, &Setup::preferred_speed);
  visit("priority", &Def::priority, &Setup::priority);
  visit("max_braking", &Def::max_braking, &Setup::max_braking);
  visit("layers", &Def::layers, &Setup::layers);
  visit("avoids", &Def::avoids, &Setup::avoids);
  visit("behavior", &Def::behavior, &Setup::behavior);
  visit("time_step", &Def::time_step, &Setup::time_step);
  visit("method", &Def::method, &Setup::method);
  visit("time_horizon", &Def::time_horizon, &Setup::time_horizon);
  visit("arrival_distance", &Def::arrival_distance, &Setup::arrival_distance);
  visit("start_time", &Def::start_time, &Setup::start_time);
  // scripts/fields end
};

}  // namespace

avo::RobotSetup setup_of(const avo_robot_def& def, const Where& where) {
  if (def.unused)
    fail(AVO_ERROR_INVALID_VALUE,
         where / "parked" + ": found true, must be false: behavior is AVO_BEHAVIOR_PARKED");
  avo::RobotSetup setup{.model = model_of(def, where)};
  take_members(def, setup, where, for_each_member);
  return setup;
}

avo_robot_def def_of(const avo::RobotSetup& setup) {
  avo_robot_def def = {};
  def.size = sizeof def;
  give_members(setup, def, for_each_member);
  set_model(setup.model, def);
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
          .loiter = circle_of(robot.loiter),
          .lookahead = robot.lookahead};
}

avo::Neighbor neighbor_of(const avo_neighbor& neighbor, const Where& where) {
  return {
      .position = from_c(neighbor.position),
      .velocity = from_c(neighbor.velocity),
      .radius = neighbor.radius,
      .max_acceleration = neighbor.max_acceleration,
      .behavior = word<avo::Behavior>(neighbor.behavior, kWords<avo::Behavior>, where, "behavior"),
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
      .trajectory_time = neighbor.trajectory_time,
      .footprint = from_c(neighbor.footprint),
      .ahead = from_c(neighbor.pose.ahead),
      .spread = neighbor.pose.spread};
}

}  // namespace avo_c

avo_robot_def avo_default_robot_def(void) {
  return avo_c::def_of(avo::RobotSetup{});
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
  robot.lookahead = usual.lookahead;
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
  neighbor.footprint = avo_c::to_c(usual.footprint);
  return neighbor;
}

avo_result avo_cover_rectangle(double length, double width, double offset, double excess,
                               avo_footprint* footprint) {
  return avo_c::guarded([&] {
    avo_c::at(footprint, "footprint") =
        avo_c::to_c(avo::cover_rectangle(length, width, offset, excess));
  });
}

avo_result avo_cover_polygon(const avo_vec2* corners, size_t corner_count, double excess,
                             avo_footprint* footprint) {
  return avo_c::guarded([&] {
    avo_footprint& cover = avo_c::at(footprint, "footprint");
    avo_c::require_array(corners, corner_count, "corners");
    std::vector<avo::Vec2> points;
    for (std::size_t k = 0; k < corner_count; ++k) points.push_back(avo_c::from_c(corners[k]));
    cover = avo_c::to_c(avo::cover_polygon(points, excess));
  });
}

avo_vec2 avo_parting_direction(uint64_t id, uint64_t other) {
  const avo::Vec2 direction = avo::parting_direction(id, other);
  return {direction.x, direction.y};
}
