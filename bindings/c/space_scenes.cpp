// SPDX-License-Identifier: Apache-2.0
// Definitions of simulations of space, and set points of quadrotors.
#include <algorithm>
#include <limits>
#include <memory>

#include "avo/space/quadrotor.h"
#include "convert.h"
#include "handles.h"
#include "members.h"
#include "space_convert.h"

namespace avo_c {
namespace {

AVO_C_CONSTINIT Handles<avo_filter_id, avo::space::Filter> filters("filter");

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

constexpr auto for_each_of_quadrotor = [](const auto& visit) {
  using Def = avo_quadrotor;
  using avo::space::Quadrotor;
  visit("mass", &Def::mass, &Quadrotor::mass);
  visit("max_thrust", &Def::max_thrust, &Quadrotor::max_thrust);
  visit("min_thrust", &Def::min_thrust, &Quadrotor::min_thrust, AVO_UNSET);
  visit("max_tilt", &Def::max_tilt, &Quadrotor::max_tilt);
  visit("attitude_time", &Def::attitude_time, &Quadrotor::attitude_time);
  visit("tracking_error", &Def::tracking_error, &Quadrotor::tracking_error, AVO_UNSET);
};

// The members of a definition and of a setup, except for the quadrotor.
constexpr auto for_each_of_space_robot = [](const auto& visit) {
  using Def = avo_space_robot_def;
  using Setup = avo::space::RobotSetup;
  visit("position", &Def::position, &Setup::position);
  visit("velocity", &Def::velocity, &Setup::velocity);
  visit("goal", &Def::goal, &Setup::goal);
  visit("radius", &Def::radius, &Setup::radius);
  visit("max_speed", &Def::max_speed, &Setup::max_speed);
  visit("max_acceleration", &Def::max_acceleration, &Setup::max_acceleration);
  visit("preferred_speed", &Def::preferred_speed, &Setup::preferred_speed);
  visit("vertical", &Def::vertical, &Setup::vertical);
  visit("climb", &Def::climb, &Setup::climb, kUnlimited);
  visit("sink", &Def::sink, &Setup::sink, kUnlimited);
  visit("downwash", &Def::downwash, &Setup::downwash);
  visit("priority", &Def::priority, &Setup::priority);
  visit("max_braking", &Def::max_braking, &Setup::max_braking);
};

// The members of a definition and of a moving obstacle, except for the trajectory.
constexpr auto for_each_of_space_moving_obstacle = [](const auto& visit) {
  using Def = avo_space_moving_obstacle_def;
  using Obstacle = avo::space::MovingObstacle;
  visit("position", &Def::position, &Obstacle::position);
  visit("velocity", &Def::velocity, &Obstacle::velocity);
  visit("acceleration", &Def::acceleration, &Obstacle::acceleration);
  visit("radius", &Def::radius, &Obstacle::radius);
  visit("max_deviation", &Def::max_deviation, &Obstacle::max_deviation);
  visit("max_speed", &Def::max_speed, &Obstacle::max_speed);
};

// The members of a definition and of a scene, except for parts.
constexpr auto for_each_space_setting = [](const auto& visit) {
  using Def = avo_space_simulation_def;
  using Scene = avo::space::Scenario;
  visit("time_step", &Def::time_step, &Scene::time_step);
  visit("control_time", &Def::control_time, &Scene::control_time);
  visit("time_horizon", &Def::time_horizon, &Scene::time_horizon);
  visit("response_time", &Def::response_time, &Scene::response_time, AVO_UNSET);
  visit("comfort_acceleration", &Def::comfort_acceleration, &Scene::comfort_acceleration);
  visit("comfort_jerk", &Def::comfort_jerk, &Scene::comfort_jerk);
  visit("sensing_radius", &Def::sensing_radius, &Scene::sensing_radius);
  visit("arrival_distance", &Def::arrival_distance, &Scene::arrival_distance);
  visit("motion", &Def::motion, &Scene::motion);
  visit("certificate", &Def::certificate, &Scene::certificate);
  visit("max_neighbors", &Def::max_neighbors, &Scene::max_neighbors);
  visit("navigation", &Def::navigation, &Scene::navigation);
  visit("seed", &Def::seed, &Scene::seed);
  visit("never_swerves", &Def::never_swerves, &Scene::never_swerves);
};

avo::space::Quadrotor quadrotor_of(const avo_quadrotor& def, const Where& where) {
  avo::space::Quadrotor quadrotor;
  take_members(def, quadrotor, where, for_each_of_quadrotor);
  return quadrotor;
}

avo::space::RobotSetup setup_of(const avo_space_robot_def& def, const Where& where) {
  avo::space::RobotSetup setup;
  take_members(def, setup, where, for_each_of_space_robot);
  if (def.quadrotor.mass != 0.0) setup.quadrotor = quadrotor_of(def.quadrotor, where);
  return setup;
}

avo::space::Quadrotor checked(const avo_quadrotor* quadrotor) {
  const avo::space::Quadrotor own = quadrotor_of(at(quadrotor, "quadrotor"), {"quadrotor"});
  validate(own, "quadrotor");
  return own;
}

}  // namespace

avo::space::MovingObstacle obstacle_of(const avo_space_moving_obstacle_def& def,
                                       const Where& where) {
  avo::space::MovingObstacle obstacle;
  take_members(def, obstacle, where, for_each_of_space_moving_obstacle);
  require_array(def.trajectory, def.trajectory_count, (where / "trajectory").c_str());
  for (std::size_t k = 0; k < def.trajectory_count; ++k)
    obstacle.trajectory.push_back({def.trajectory[k].time, from_c(def.trajectory[k].position)});
  return obstacle;
}

avo::space::Scenario scenario_of(const avo_space_simulation_def& def) {
  avo::space::Scenario scenario;
  take_members(def, scenario, {}, for_each_space_setting);
  scenario.sensing = sensing_of(def.sensing);
  scenario.sensing.localization = localization_of(def.localization);
  scenario.sensing_error = error_of(def.sensing_error);
  scenario.duration = std::max(scenario.duration, def.time_step);
  for_each(def.robots, def.robot_count, "robots", avo_default_space_robot_def(),
           [&](const avo_space_robot_def& robot, const Where& where) {
             scenario.robots.push_back(setup_of(robot, where));
           });
  for_each(def.moving_obstacles, def.moving_obstacle_count, "moving_obstacles",
           avo_default_space_moving_obstacle_def(),
           [&](const avo_space_moving_obstacle_def& obstacle, const Where& where) {
             scenario.moving_obstacles.push_back(obstacle_of(obstacle, where));
           });
  read_boxes(def.boxes, def.box_count, scenario.boxes);
  return scenario;
}

}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_space_robot_def avo_default_space_robot_def(void) {
  avo_space_robot_def def = {};
  def.size = sizeof def;
  give_members(avo::space::RobotSetup{}, def, for_each_of_space_robot);
  def.quadrotor.min_thrust = def.quadrotor.tracking_error = AVO_UNSET;
  return def;
}

avo_space_moving_obstacle_def avo_default_space_moving_obstacle_def(void) {
  avo_space_moving_obstacle_def def = {};
  def.size = sizeof def;
  give_members(avo::space::MovingObstacle{}, def, for_each_of_space_moving_obstacle);
  return def;
}

avo_space_simulation_def avo_default_space_simulation_def(void) {
  avo_space_simulation_def def = {};
  def.size = sizeof def;
  give_members(avo::space::Scenario{}, def, for_each_space_setting);
  def.sensing = to_c(avo::SensingModel{});
  def.localization = to_c(avo::LocalizationNoise{});
  def.sensing_error = to_c(std::optional<avo::SensingError>{});
  return def;
}

avo_result avo_get_quadrotor_limits(const avo_quadrotor* quadrotor, avo_quadrotor_limits* limits) {
  return guarded([&] {
    avo_quadrotor_limits& to = at(limits, "limits");
    const avo::space::QuadrotorLimits found = limits_of(checked(quadrotor));
    to = {found.max_acceleration, found.deviation, found.delay};
  });
}

avo_result avo_create_filter(const avo_quadrotor* quadrotor, double fleet_delay, double time_step,
                             avo_filter_id* filter) {
  return guarded([&] {
    avo_filter_id& id = at(filter, "filter");
    id = filters.add(std::make_unique<avo::space::Filter>(limits_of(checked(quadrotor)),
                                                          fleet_delay, time_step));
  });
}

avo_result avo_destroy_filter(avo_filter_id filter) {
  return guarded([&] { filters.take(filter); });
}

bool avo_filter_is_valid(avo_filter_id filter) {
  return filters.find(filter) != nullptr;
}

avo_result avo_filter_add(avo_filter_id filter, avo_vec3 position, avo_vec3 velocity,
                          avo_vec3 acceleration) {
  return guarded(
      [&] { filters.at(filter).add(from_c(position), from_c(velocity), from_c(acceleration)); });
}

avo_result avo_filter_get_times(avo_filter_id filter, double* begin, double* end) {
  return guarded([&] {
    const avo::space::Filter& own = filters.at(filter);
    double& first = at(begin, "begin");
    at(end, "end") = own.end();
    first = own.begin();
  });
}

avo_result avo_filter_get_set_point(avo_filter_id filter, double time, avo_set_point* set_point) {
  return guarded([&] {
    avo_set_point& to = at(set_point, "set_point");
    const avo::space::SetPoint found = filters.at(filter).at(time);
    to = {to_c(found.position), to_c(found.velocity), to_c(found.acceleration)};
  });
}
