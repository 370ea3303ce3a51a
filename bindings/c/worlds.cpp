// SPDX-License-Identifier: Apache-2.0
// The parts of a simulation besides robots, and its settings.
#include <bit>
#include <cmath>
#include <limits>

#include "convert.h"
#include "external.h"
#include "members.h"

namespace avo_c {
namespace {

std::vector<avo::TimedPlace> places_of(const avo_timed_place* places, std::size_t count,
                                       const std::string& name) {
  require_array(places, count, name.c_str());
  std::vector<avo::TimedPlace> result;
  result.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    result.push_back({places[k].time, from_c(places[k].position)});
  return result;
}

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// The members of a definition and of a scene, except for texts and parts.
constexpr auto for_each_setting = [](const auto& visit) {
  using Def = avo_simulation_def;
  using Scene = avo::Scenario;
  visit("time_step", &Def::time_step, &Scene::time_step);
  visit("duration", &Def::duration, &Scene::duration);
  visit("control_time", &Def::control_time, &Scene::control_time);
  visit("response_time", &Def::response_time, &Scene::response_time, kNotANumber);
  visit("execution_error", &Def::execution_error, &Scene::execution_error, kNotANumber);
  visit("comfort_acceleration", &Def::comfort_acceleration, &Scene::comfort_acceleration);
  visit("comfort_jerk", &Def::comfort_jerk, &Scene::comfort_jerk);
  visit("margin", &Def::margin, &Scene::margin);
  visit("never_swerves", &Def::never_swerves, &Scene::never_swerves);
  visit("time_horizon", &Def::time_horizon, &Scene::time_horizon);
  visit("sensing_radius", &Def::sensing_radius, &Scene::sensing_radius);
  visit("max_neighbors", &Def::max_neighbors, &Scene::max_neighbors);
  visit("method", &Def::method, &Scene::method);
  visit("certificate", &Def::certificate, &Scene::certificate);
  visit("motion", &Def::motion, &Scene::motion);
  visit("arrival_distance", &Def::arrival_distance, &Scene::arrival_distance);
  visit("seed", &Def::seed, &Scene::seed);
  visit("navigation", &Def::navigation, &Scene::navigation);
  visit("right_of_way", &Def::right_of_way, &Scene::right_of_way);
  visit("clock", &Def::clock, &Scene::clock);
  visit("longest_step", &Def::longest_step, &Scene::longest_step);
  visit("allow_broken_assumptions", &Def::allow_broken_assumptions,
        &Scene::allow_broken_assumptions);
};

// The members of a definition and of a moving obstacle, except for lists.
constexpr auto for_each_of_mover = [](const auto& visit) {
  using Def = avo_moving_obstacle_def;
  using Mover = avo::MovingObstacle;
  visit("position", &Def::position, &Mover::position);
  visit("velocity", &Def::velocity, &Mover::velocity);
  visit("acceleration", &Def::acceleration, &Mover::acceleration);
  visit("radius", &Def::radius, &Mover::radius);
  visit("max_deviation", &Def::max_deviation, &Mover::max_deviation);
  visit("max_speed", &Def::max_speed, &Mover::max_speed);
};

void read_settings(const avo_simulation_def& def, avo::Scenario& scenario) {
  const Where here;
  require_unused(def.unused, here, "samples");
  take_members(def, scenario, here, for_each_setting);
  scenario.name = def.name == nullptr ? "" : def.name;
  scenario.sensing = sensing_of(def.sensing);
  scenario.sensing.localization = localization_of(def.localization);
  scenario.sensing_error = error_of(def.sensing_error);
  if (def.execution != nullptr)
    scenario.execution = std::bit_cast<avo::ExecutionModel>(*def.execution);
  scenario.external_method = def.external_method == nullptr ? "" : def.external_method;
  scenario.external = external_of(def.external, def.external_context);
}

}  // namespace

avo::LocalizationNoise localization_of(const avo_localization_noise& noise) {
  return {noise.position,
          word<avo::NoiseDistribution>(noise.distribution, 2, {"localization"}, "distribution"),
          unless_zero(noise.truncated)};
}

avo_localization_noise to_c(const avo::LocalizationNoise& noise) {
  return {noise.position, noise.truncated.value_or(0.0),
          static_cast<avo_noise_distribution>(noise.distribution)};
}

avo::SensingModel sensing_of(const avo_sensing_model& sensing) {
  avo::SensingModel result;
  const avo_measurement_noise& noise = sensing.noise;
  result.noise = {
      noise.position, noise.velocity,
      word<avo::NoiseDistribution>(noise.distribution, 2, {"sensing"}, "noise.distribution"),
      unless_zero(noise.truncated)};
  result.delay = sensing.delay;
  result.dropped = sensing.dropped;
  result.occlusion = sensing.occlusion;
  return result;
}

avo_sensing_model to_c(const avo::SensingModel& sensing) {
  const avo::MeasurementNoise& noise = sensing.noise;
  return {{noise.position, noise.velocity, noise.truncated.value_or(0.0),
           static_cast<avo_noise_distribution>(noise.distribution)},
          sensing.dropped,
          sensing.delay,
          sensing.occlusion};
}

std::optional<avo::SensingError> error_of(const avo_sensing_error& error) {
  if (std::isnan(error.position) && std::isnan(error.velocity)) return std::nullopt;
  return avo::SensingError{error.position, error.velocity};
}

avo_sensing_error to_c(const std::optional<avo::SensingError>& error) {
  return error ? avo_sensing_error{error->position, error->velocity}
               : avo_sensing_error{kNotANumber, kNotANumber};
}

avo::MovingObstacle obstacle_of(const avo_moving_obstacle_def& def, const Where& where) {
  avo::MovingObstacle obstacle;
  take_members(def, obstacle, where, for_each_of_mover);
  obstacle.path = points_of(def.path, def.path_count, where / "path");
  obstacle.trajectory = places_of(def.trajectory, def.trajectory_count, where / "trajectory");
  start_on_trajectory(obstacle);
  return obstacle;
}

avo_moving_obstacle_def def_of(const avo::MovingObstacle& obstacle) {
  avo_moving_obstacle_def def = {};
  def.size = sizeof def;
  give_members(obstacle, def, for_each_of_mover);
  def.path = reinterpret_cast<const avo_vec2*>(obstacle.path.data());
  def.path_count = obstacle.path.size();
  def.trajectory = reinterpret_cast<const avo_timed_place*>(obstacle.trajectory.data());
  def.trajectory_count = obstacle.trajectory.size();
  return def;
}

avo::StaticObstacle obstacle_of(const avo_obstacle_def& def, const Where& where) {
  avo::StaticObstacle obstacle;
  require_array(def.chains, def.chain_count, (where / "chains").c_str());
  for (std::size_t k = 0; k < def.chain_count; ++k) {
    const avo_chain& chain = def.chains[k];
    obstacle.chains.push_back(
        {points_of(chain.points, chain.point_count, where / "points"), chain.closed});
  }
  obstacle.radius = def.radius;
  obstacle.fill = word<avo::Fill>(def.fill, 3, where, "fill");
  obstacle.layers = {def.layers};
  return obstacle;
}

avo_obstacle_def def_of(const avo::StaticObstacle& obstacle, std::vector<avo_chain>& chains) {
  if (chains.empty())
    for (const avo::Chain& chain : obstacle.chains)
      chains.push_back({reinterpret_cast<const avo_vec2*>(chain.points.data()), chain.points.size(),
                        chain.closed});
  return {sizeof(avo_obstacle_def),
          chains.data(),
          chains.size(),
          obstacle.radius,
          static_cast<avo_fill>(obstacle.fill),
          obstacle.layers.bits};
}

std::vector<avo::StaticObstacle> obstacles_of(const avo_obstacle_def* obstacles,
                                              std::size_t count) {
  std::vector<avo::StaticObstacle> result;
  for_each(obstacles, count, "obstacles", avo_default_obstacle_def(),
           [&](const avo_obstacle_def& obstacle, const Where& where) {
             result.push_back(obstacle_of(obstacle, where));
           });
  return result;
}

avo::Scenario scenario_of(const avo_simulation_def& def) {
  avo::Scenario scenario;
  read_settings(def, scenario);
  for_each(def.robots, def.robot_count, "robots", avo_default_robot_def(),
           [&](const avo_robot_def& robot, const Where& where) {
             scenario.robots.push_back(setup_of(robot, where));
           });
  for_each(def.moving_obstacles, def.moving_obstacle_count, "moving_obstacles",
           avo_default_moving_obstacle_def(),
           [&](const avo_moving_obstacle_def& obstacle, const Where& where) {
             scenario.moving_obstacles.push_back(obstacle_of(obstacle, where));
           });
  scenario.obstacles = obstacles_of(def.obstacles, def.obstacle_count);
  for_each(def.teams, def.team_count, "teams", avo_default_team_def(),
           [&](const avo_team_def& team, const Where& where) {
             scenario.teams.push_back(team_of(team, where));
           });
  return scenario;
}

avo_simulation_def settings_of(const avo::Scenario& scenario) {
  avo_simulation_def def = {};
  def.size = sizeof def;
  give_members(scenario, def, for_each_setting);
  def.name = scenario.name.c_str();
  def.sensing = to_c(scenario.sensing);
  def.localization = to_c(scenario.sensing.localization);
  def.sensing_error = to_c(scenario.sensing_error);
  if (scenario.execution)
    def.execution = reinterpret_cast<const avo_execution_model*>(&*scenario.execution);
  def.external_method = scenario.external_method.c_str();
  def.workers = 1;
  return def;
}

}  // namespace avo_c

avo_simulation_def avo_default_simulation_def(void) {
  avo_simulation_def def = avo_c::settings_of({});
  def.name = def.external_method = nullptr;
  return def;
}

avo_moving_obstacle_def avo_default_moving_obstacle_def(void) {
  return avo_c::def_of(avo::MovingObstacle{});
}

avo_obstacle_def avo_default_obstacle_def(void) {
  avo_obstacle_def def = {};
  def.size = sizeof def;
  def.layers = AVO_ALL_LAYERS;
  return def;
}
