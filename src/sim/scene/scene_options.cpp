// SPDX-License-Identifier: Apache-2.0
// The options that a scene gives to the planners of its robots.
#include <algorithm>
#include <cmath>

#include "avo/scenario.h"
#include "planner/options.h"
#include "robots/model.h"
#include "sim/columns/fleet.h"
#include "sim/scene/scene_checks.h"
#include "sim/sensing/senses.h"

namespace avo::inline sim {
namespace {

// The longest step of the robots that decide.
double longest_step_of(const Scenario& scenario) {
  if (scenario.longest_step) return *scenario.longest_step;
  double longest = 0.0;
  for (const RobotSetup& robot : scenario.robots) {
    if (!is_parked(robot)) longest = std::max(longest, time_step_of(scenario, robot));
  }
  return longest > 0.0 ? longest : scenario.time_step;
}

}  // namespace

SensingError unforeseen(const Scenario& scenario) {
  const double longest = longest_step_of(scenario);
  SensingError most;
  for (const RobotSetup& robot : scenario.robots) {
    if (is_parked(robot)) continue;
    const SensingError own = unforeseen(robot.model, robot.max_acceleration, longest);
    most.position = std::max(most.position, own.position);
    most.velocity = std::max(most.velocity, own.velocity);
  }
  return most;
}

namespace {

// Takes the scene's options for robots of its own method.
void take_settings(const Scenario& scenario, PlannerOptions& options) {
  if (scenario.control_time) options.control_time = *scenario.control_time;
  if (scenario.time_horizon) options.time_horizon = *scenario.time_horizon;
  if (scenario.response_time) options.response_time = *scenario.response_time;
  options.comfort_acceleration = scenario.comfort_acceleration;
  options.comfort_jerk = scenario.comfort_jerk;
  options.margin = scenario.margin;
  options.never_swerves = scenario.never_swerves;
  if (scenario.certificate) options.certificate = *scenario.certificate;
}

PlannerOptions options_of(const Scenario& scenario, Method method, const Agreed& agreed) {
  PlannerOptions options = default_options(method);
  options.motion = scenario.motion;
  options.time_step = scenario.time_step;
  options.max_neighbors = scenario.max_neighbors;
  options.arrival_distance = scenario.arrival_distance;
  options.clock = scenario.clock;
  options.longest_step = agreed.longest_step;
  if (method == scenario.method) take_settings(scenario, options);
  if (options.certificate == Certificate::braking_trajectories)
    options.sensing_error = agreed.declared;
  options.localization_error = most_lost(scenario.sensing.localization);
  options.wall_range = wall_range(!scenario.moving_obstacles.empty());
  const MeasurementNoise& noise = scenario.sensing.noise;
  if (noise.distribution == NoiseDistribution::gaussian) {
    const double carried = scenario.sensing.delay * scenario.time_step * noise.velocity;
    options.sensing_noise.position = norm(Vec2{noise.position, carried});
    options.sensing_noise.velocity = noise.velocity;
  }
  return options;
}

}  // namespace

Agreed agreed_on(const Scenario& scenario) {
  return {scenario.clock == Clock::free ? longest_step_of(scenario) : 0.0,
          scenario.sensing_error ? *scenario.sensing_error : declared_error(scenario)};
}

PlannerOptions planner_options(const Scenario& scenario, const RobotSetup& robot,
                               const Agreed& agreed) {
  PlannerOptions options = options_of(scenario, method_of(scenario, robot), agreed);
  options.time_step = time_step_of(scenario, robot);
  if (robot.time_horizon) options.time_horizon = *robot.time_horizon;
  options.arrival_distance = arrival_distance_of(scenario, robot);
  return options;
}

PlannerOptions certified_options(const Scenario& scenario) {
  PlannerOptions options = planner_options(scenario);
  if (options.certificate != Certificate::none) return options;
  const bool some =
      std::any_of(scenario.robots.begin(), scenario.robots.end(), [&](const RobotSetup& robot) {
        return certificate_of(scenario, robot) != Certificate::none;
      });
  return some ? options_of(scenario, Method::avo, agreed_on(scenario)) : options;
}

void forget_undeclared_error(Scenario& scenario) {
  if (certified_options(scenario).certificate == Certificate::none) scenario.sensing_error.reset();
}

}  // namespace avo::inline sim

namespace avo {

std::vector<Wall> parked_discs(const std::vector<RobotSetup>& robots) {
  std::vector<Wall> discs;
  for (const RobotSetup& robot : robots) {
    if (is_parked(robot)) discs.push_back(parked_wall(robot));
  }
  return discs;
}

PlannerOptions planner_options(const Scenario& scenario) {
  return options_of(scenario, scenario.method, agreed_on(scenario));
}

PlannerOptions planner_options(const Scenario& scenario, const RobotSetup& robot) {
  return planner_options(scenario, robot, agreed_on(scenario));
}

SensingError declared_error(const Scenario& scenario) {
  SensingError error = most_noise(scenario.sensing.noise);
  const SensingError off = body_error(scenario);
  error.position += off.position, error.velocity += off.velocity;
  if (scenario.sensing.delay > 0) {
    double strongest = 0.0;  // m/s²
    for (const RobotSetup& robot : scenario.robots)
      if (!is_parked(robot)) strongest = std::max(strongest, top_acceleration(traits_of(robot)));
    for (const MovingObstacle& obstacle : scenario.moving_obstacles)
      strongest = std::max(strongest, obstacle.max_deviation);
    const double time = scenario.sensing.delay * scenario.time_step;
    error.position += time * error.velocity + 0.5 * strongest * time * time;
    error.velocity += strongest * time;
  }
  if (scenario.clock == Clock::free) {
    const auto [unseen_way, unseen_speed] = unforeseen(scenario);
    error.position += unseen_way, error.velocity += unseen_speed;
  }
  return error;
}

std::int64_t last_step(const Scenario& scenario, double time) {
  // The quotient of two decimal fractions may be slightly less than the intended whole number.
  return static_cast<std::int64_t>(std::floor(time / scenario.time_step * (1.0 + 1e-12)));
}

}  // namespace avo
