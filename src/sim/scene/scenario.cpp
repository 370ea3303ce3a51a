// SPDX-License-Identifier: Apache-2.0
// Decides which scenes can be simulated at all (the ranges of the paper's constants, §VI-A).
#include "avo/scenario.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "avo/response.h"
#include "core/ranges.h"
#include "fields/scene_fields.h"
#include "fields/sensing_checks.h"
#include "planner/options.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/scene/one_sided.h"
#include "sim/scene/scene_checks.h"
#include "sim/sensing/senses.h"

namespace avo {
namespace {

constexpr int kMostRemembered = 1 << 16;  // steps

void check_duration(const Scenario& scenario) {
  double dt = scenario.time_step;
  if (scenario.clock == Clock::free) {
    require("duration", scenario.duration, Range{0.0, kMostClockTime, true}, "s");
    for (const RobotSetup& robot : scenario.robots)
      dt = std::min(dt, time_step_of(scenario, robot));
  }
  require("duration", scenario.duration, kPositive, "s");
  if (scenario.duration < dt)
    refuse("duration", text(scenario.duration), ">= time_step = " + text(dt) + " s");
  if (scenario.duration / dt > static_cast<double>(kMostSteps))
    refuse("duration", text(scenario.duration),
           "at most " + std::to_string(kMostSteps) + " steps of " + text(dt) + " s");
}

// Checks that decisions are at whole nanoseconds.
template <typename Name>
void check_clock(const Name& name, double time_step) {
  require(name, time_step, Range{0.0, kMostClockTime, true}, "s");
  if (whole_nanoseconds(time_step)) return;
  const double near = std::max(1.0, std::round(time_step * 1e9)) / 1e9;
  refuse(std::string(name), text(time_step),
         "a whole number of nanoseconds where clock is free, such as " + text(near) + " s");
}

// Every robot's steps are remembered, as far back as any measurement.
void check_memory(const Scenario& scenario, const PlannerOptions& options) {
  if (!senses_by_time(scenario)) return;
  const double past = time_remembered(scenario, options.longest_step);
  const double least = past / static_cast<double>(kMostRemembered);
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const double step = time_step_of(scenario, scenario.robots[i]);
    if (is_parked(scenario.robots[i]) || step >= least) continue;
    refuse(std::string(Place{"robots", i, "time_step"}), text(step),
           ">= " + text(least) + " s, of which " + std::to_string(kMostRemembered) +
               " are in the " + text(past) + " s that sensing looks back");
  }
}

void check_clocks(const Scenario& scenario, const PlannerOptions& options) {
  const bool is_free = scenario.clock == Clock::free;
  if (is_free) check_clock("time_step", scenario.time_step);
  if (scenario.longest_step && !is_free)
    refuse("longest_step", text(*scenario.longest_step), "left out where clock is common");
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const RobotSetup& robot = scenario.robots[i];
    const Place place{"robots", i, "time_step"};
    if (robot.time_step && !is_free)
      refuse(std::string(place), text(*robot.time_step), "left out where clock is common");
    if (!is_free || is_parked(robot)) continue;
    const double step = time_step_of(scenario, robot);
    if (robot.time_step) check_clock(place, step);
    if (step > options.longest_step)
      refuse(std::string(place), text(step),
             "<= longest_step = " + text(options.longest_step) + " s");
  }
  if (is_free) check_memory(scenario, options);
}

// Checks the robots with values of their own.
void check_methods(const Scenario& scenario) {
  const Agreed agreed = agreed_on(scenario);
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const RobotSetup& robot = scenario.robots[i];
    if (!robot.method && !robot.time_horizon && !robot.time_step && !robot.arrival_distance)
      continue;
    const Method method = method_of(scenario, robot);
    if (reaches_within_step(method) && scenario.motion != Motion::held)
      refuse(std::string(Place{"robots", i, "method"}), to_string(method),
             "another one where motion is exponential");
    validate(planner_options(scenario, robot, agreed), "robots." + std::to_string(i) + ".");
  }
}

void check_declared(const Scenario& scenario, const PlannerOptions& certified) {
  const Certificate certificate = certified.certificate;
  if (!scenario.sensing_error || *scenario.sensing_error == SensingError{} ||
      certificate == Certificate::braking_trajectories)
    return;
  refuse("sensing_error", "one", std::string("none with certificate ") + to_string(certificate));
}

// Braking may last only for as many steps as can be tested one by one.
void check_braking(const Scenario& scenario, const PlannerOptions& options) {
  const double steps = static_cast<double>(kMostBrakingSteps);
  // of any robot, which counts the others' braking in its own steps
  double time_step = options.time_step;
  for (const RobotSetup& robot : scenario.robots)
    if (certificate_of(scenario, robot) == options.certificate)
      time_step = std::min(time_step, time_step_of(scenario, robot));
  const double longest =
      options.motion == Motion::held
          ? steps * time_step
          : steps * Response::proportional(options.control_time).rate(options.time_step) *
                options.control_time;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const RobotSetup& robot = scenario.robots[i];
    if (certificate_of(scenario, robot) != options.certificate) continue;
    const double most = longest * braking_limit(robot);
    if (robot.max_speed <= most) continue;
    refuse(std::string(Place{"robots", i, "max_speed"}), text(robot.max_speed),
           "<= " + text(most) + " m/s, " + std::to_string(kMostBrakingSteps) +
               " steps of braking, with a certificate");
  }
}

// The certificate tests the sides of a step's triangle, not its interior: no wall may hide there.
void check_beside_walls(const Scenario& scenario, Certificate certificate) {
  const std::vector<RobotSetup>& robots = scenario.robots;
  const bool has_walls = !scenario.obstacles.empty() || !parked_discs(robots).empty();
  for (std::size_t i = 0; i < robots.size() && has_walls; ++i) {
    const RobotSetup& robot = robots[i];
    if (is_parked(robot) || certificate_of(scenario, robot) != certificate) continue;
    const double time_step = time_step_of(scenario, robot);
    const double most = std::min(change_limit(robot) * time_step, 2.0 * robot.max_speed);
    const double height = 0.25 * most * time_step;
    const double radius = route_radius(robot.model, disc_radius(robot));
    if (radius > height) continue;
    refuse(std::string(Place{"robots", i, "radius"}), text(radius),
           "> " + text(height) + " m beside obstacles, with a certificate: what a step of " +
               text(time_step) + " s can turn off its way");
  }
}

// The promises to and of a robot that flies hold only under these conditions.
void check_flights(const Scenario& scenario, const PlannerOptions& options) {
  const std::vector<RobotSetup>& robots = scenario.robots;
  const auto first = std::find_if(robots.begin(), robots.end(),
                                  [](const RobotSetup& r) { return !can_rest(r.model); });
  if (first == robots.end()) return;
  const std::string among = kAmongFlights;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!promises(robots[i].behavior))
      refuse(std::string(Place{"robots", i, "behavior"}), to_string(robots[i].behavior),
             "decides" + among + ", which cannot stop for it");
  }
  if (!method_traits(options.method).has_rules)
    refuse("method", to_string(options.method), "avo" + among);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (const Method own = method_of(scenario, robots[i]); !method_traits(own).has_rules)
      refuse(std::string(Place{"robots", i, "method"}), to_string(own), "avo" + among);
  }
  if (options.motion != Motion::held) refuse("motion", to_string(options.motion), "held" + among);
  if (options.clock != Clock::common) refuse("clock", to_string(options.clock), "common" + among);
  if (!scenario.sensing.is_exact()) refuse("sensing", "one that is not exact", "left out" + among);
  if (options.sensing_error != SensingError{})
    refuse("sensing_error", "one that is not 0", "left out" + among);
}

void check_one_sided(const Scenario& scenario) {
  if (const auto pair = find_impossible(scenario.robots))
    refuse(std::string(Place{"robots", pair->avoiding, "avoids"}),
           "robot " + std::to_string(pair->avoided) + ", which does not avoid it",
           "both or neither: " + std::string(pair->reason));
}

void check_certificate(const Scenario& scenario, const PlannerOptions& options) {
  if (options.certificate == Certificate::none) return;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const RobotSetup& robot = scenario.robots[i];
    if (!is_holonomic(robot.model) && certificate_of(scenario, robot) == options.certificate &&
        options.motion != Motion::held)
      refuse(std::string(Place{"robots", i, "model"}), "one that is not holonomic",
             "holonomic with a certificate where motion is exponential");
  }
  check_braking(scenario, options);
  check_beside_walls(scenario, options.certificate);
  if (!scenario.sensing_error || scenario.clock == Clock::common) return;
  constexpr double kRounding = 1.0 + 1e-9;
  const SensingError least = unforeseen(scenario);
  const auto& [position, velocity] = *scenario.sensing_error;
  const auto require_least = [](const char* key, double found, double least_of_all,
                                const char* unit) {
    if (least_of_all > kRounding * found)
      refuse(std::string("sensing_error.") + key, text(found),
             ">= " + text(least_of_all) + unit +
                 ", what the rest of a step of a car may add where clock is free");
  };
  require_least("position", position, least.position, " m");
  require_least("velocity", velocity, least.velocity, " m/s");
}

}  // namespace

void validate(const Scenario& scenario) {
  check_sensing(scenario.sensing);
  const PlannerOptions options = planner_options(scenario);
  const PlannerOptions certified = certified_options(scenario);
  validate(options, "");
  check_declared(scenario, certified);
  check_clocks(scenario, options);
  check_duration(scenario);
  if (scenario.sensing_radius) require("sensing_radius", *scenario.sensing_radius, kPositive, "m");
  const auto robots = static_cast<std::int64_t>(scenario.robots.size());
  if (robots > kMostRobots)
    refuse("robots", std::to_string(robots), "at most " + std::to_string(kMostRobots));
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    check_robot(i, scenario.robots[i], scenario.time_step);
  check_methods(scenario);
  check_execution(scenario);
  check_footprints(scenario);
  check_external(scenario);
  check_obstacles(scenario);
  check_teams(scenario);
  check_flights(scenario, options);
  check_one_sided(scenario);
  check_certificate(scenario, certified);
}

}  // namespace avo
