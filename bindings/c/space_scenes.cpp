// SPDX-License-Identifier: Apache-2.0
// Definitions of simulations of space, and set points of quadrotors.
#include <cmath>
#include <limits>
#include <memory>

#include "avo/space/quadrotor.h"
#include "convert.h"
#include "handles.h"
#include "space_convert.h"

namespace avo_c {
namespace {

AVO_C_CONSTINIT Handles<avo_filter_id, avo::space::Filter> filters("filter");

std::optional<double> unless_unset(double value) {
  return value == static_cast<double>(AVO_UNSET) ? std::nullopt : std::optional(value);
}
// A speed along the vertical that is not limited is infinite in C.
std::optional<double> unless_infinite(double value) {
  return value == std::numeric_limits<double>::infinity() ? std::nullopt : std::optional(value);
}

avo::space::RobotSetup setup_of(const avo_space_robot_def& def) {
  avo::space::RobotSetup setup;
  setup.position = from_c(def.position);
  setup.velocity = from_c(def.velocity);
  setup.goal = from_c(def.goal);
  setup.radius = def.radius;
  setup.max_speed = def.max_speed;
  setup.max_acceleration = def.max_acceleration;
  setup.preferred_speed = def.preferred_speed;
  setup.vertical = def.vertical;
  setup.climb = unless_infinite(def.climb);
  setup.sink = unless_infinite(def.sink);
  setup.downwash = def.downwash;
  setup.priority = def.priority;
  setup.max_braking = unless_zero(def.max_braking);
  if (def.quadrotor.mass != 0.0) setup.quadrotor = from_c(def.quadrotor);
  return setup;
}

avo::space::Quadrotor checked(const avo_quadrotor* quadrotor) {
  const avo::space::Quadrotor own = from_c(at(quadrotor, "quadrotor"));
  validate(own, "quadrotor");
  return own;
}

}  // namespace

avo::space::Quadrotor from_c(const avo_quadrotor& quadrotor) {
  return {quadrotor.mass,     quadrotor.max_thrust,    unless_unset(quadrotor.min_thrust),
          quadrotor.max_tilt, quadrotor.attitude_time, unless_unset(quadrotor.tracking_error)};
}

avo::space::Scenario scenario_of(const avo_space_simulation_def& def) {
  const Where here;
  avo::space::Scenario scenario;
  scenario.time_step = def.time_step;
  scenario.duration = std::max(scenario.duration, def.time_step);
  scenario.control_time = unless_zero(def.control_time);
  scenario.time_horizon = unless_zero(def.time_horizon);
  scenario.response_time = unless_unset(def.response_time);
  scenario.comfort_acceleration = unless_zero(def.comfort_acceleration);
  scenario.comfort_jerk = unless_zero(def.comfort_jerk);
  scenario.sensing_radius = unless_zero(def.sensing_radius);
  scenario.arrival_distance = def.arrival_distance;
  scenario.motion = word<avo::Motion>(def.motion, 2, here, "motion");
  if (def.certificate != AVO_UNSET)
    scenario.certificate = word<avo::Certificate>(def.certificate, 3, here, "certificate");
  scenario.max_neighbors = unless_zero(def.max_neighbors);
  for_each(def.robots, def.robot_count, "robots", avo_default_space_robot_def(),
           [&](const avo_space_robot_def& robot, const Where&) {
             scenario.robots.push_back(setup_of(robot));
           });
  require_array(def.boxes, def.box_count, "boxes");
  for (std::size_t k = 0; k < def.box_count; ++k) scenario.boxes.push_back(from_c(def.boxes[k]));
  return scenario;
}

}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_space_robot_def avo_default_space_robot_def(void) {
  const avo::space::RobotSetup setup;
  avo_space_robot_def def = {};
  def.size = sizeof def;
  def.radius = setup.radius;
  def.max_speed = setup.max_speed;
  def.max_acceleration = setup.max_acceleration;
  def.preferred_speed = setup.preferred_speed;
  def.vertical = setup.vertical;
  def.climb = def.sink = std::numeric_limits<double>::infinity();
  def.downwash = setup.downwash;
  def.priority = setup.priority;
  def.quadrotor.min_thrust = def.quadrotor.tracking_error = AVO_UNSET;
  return def;
}

avo_space_simulation_def avo_default_space_simulation_def(void) {
  const avo::space::Scenario scenario;
  avo_space_simulation_def def = {};
  def.size = sizeof def;
  def.time_step = scenario.time_step;
  def.response_time = AVO_UNSET;
  def.arrival_distance = scenario.arrival_distance;
  def.motion = static_cast<avo_motion>(scenario.motion);
  def.certificate = AVO_UNSET;
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
