// SPDX-License-Identifier: Apache-2.0
// The output of --verbose, on the standard error output.
#include "reports/settings_report.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <string_view>

#include "arguments/files.h"
#include "avo/simd.h"
#include "avo/version.h"
#include "avo_io/scene.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

void tell(std::string_view name, const std::string& value) {
  say(fmt::format("{:<17} {}", name, value));
}

std::string origin(const std::string& scene) {
  if (scene == "-") return "from the standard input";
  return avo_io::is_builtin_scene(scene) ? "built in" : "from " + scene;
}

std::string seconds(double value) {
  return fmt::format("{} s", value);
}

/// Returns the response times that take effect, for robots that decide and do not fly.
std::string response_times(const avo::Scenario& scenario, avo::PlannerOptions options) {
  if (!(options.response_time > 0.0) && !options.comfort_jerk) return "0: at once";
  double least = 0.0, most = 0.0;
  for (const avo::RobotSetup& robot : scenario.robots) {
    if (is_parked(robot) || !can_rest(robot.model)) continue;
    options.time_step = time_step_of(scenario, robot);
    const double own = avo::response_time_of(options, robot.max_speed, robot.max_acceleration);
    least = least > 0.0 ? std::min(least, own) : own;
    most = std::max(most, own);
  }
  if (!(most > 0.0)) return "of nobody";
  return least == most ? fmt::format("{:.6g} s", most)
                       : fmt::format("{:.6g} s to {:.6g} s", least, most);
}

/// Returns the scene's method, and the number of robots that decide by other methods.
std::string methods_of(const avo::Scenario& scenario) {
  std::map<avo::Method, std::int64_t> others;
  for (const avo::RobotSetup& robot : scenario.robots)
    if (method_of(scenario, robot) != scenario.method) ++others[method_of(scenario, robot)];
  std::string text(method_name(scenario));
  for (const auto& [method, count] : others)
    text += fmt::format(", {} robots by {}", count, avo::to_string(method));
  return text;
}

}  // namespace

void tell_settings(const SceneArguments& arguments, const avo::Scenario& scenario,
                   const avo_io::SceneSource& source) {
  if (volume() != Volume::verbose) return;
  const avo::PlannerOptions options = planner_options(scenario);
  tell("scene", fmt::format("{}, {}", scenario.name, origin(arguments.scene)));
  for (const avo_io::SceneFile& file : source.files)
    if (!file.builtin) tell("file", file.path);
  for (const std::string& override : arguments.overrides) tell("set", override);
  const auto parked = std::count_if(scenario.robots.begin(), scenario.robots.end(), avo::is_parked);
  tell("robots", fmt::format("{}, {} of them parked", scenario.robots.size(), parked));
  tell("obstacles",
       fmt::format("{} moving, {} static of {} walls", scenario.moving_obstacles.size(),
                   scenario.obstacles.size(), avo::walls_of(scenario.obstacles).size()));
  tell("method", methods_of(scenario));
  tell("certificate", avo::to_string(options.certificate));
  tell("motion", avo::to_string(scenario.motion));
  tell("control_time", seconds(options.control_time) + " (delta)");
  tell("response_time", response_times(scenario, options));
  tell("time_horizon", seconds(options.time_horizon) + " (tau)");
  tell("time_step", seconds(scenario.time_step));
  tell("duration", seconds(scenario.duration));
  tell("sensing_radius", fmt::format("{} m{}", avo::sensing_radius_of(scenario),
                                     scenario.sensing_radius ? "" : ", what the robots need"));
  tell("max_neighbors", scenario.max_neighbors ? std::to_string(*scenario.max_neighbors) : "all");
  tell("clock", scenario.clock == avo::Clock::free ? "free" : "common");
  tell("seed", std::to_string(scenario.seed));
}

void tell_machine(const avo::Simulation& simulation) {
  if (volume() != Volume::verbose) return;
  tell("threads", std::to_string(simulation.threads()));
  tell("instructions", avo::simd_target());
  tell("version", avo::kVersion);
}

}  // namespace avo_cli
