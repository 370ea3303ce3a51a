// SPDX-License-Identifier: Apache-2.0
// avo scenes, avo validate, avo schema.
#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/files.h"
#include "arguments/own_methods.h"
#include "avo/reachability.h"
#include "avo_io/errors.h"
#include "avo_io/printable.h"
#include "avo_io/scene.h"
#include "exit_codes.h"
#include "reports/assumptions.h"
#include "reports/settings_report.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {

avo::Scenario with_overrides(const SceneArguments& arguments, avo_io::SceneSource& source,
                             bool may_lack_robots) {
  const std::vector<avo_io::OwnMethod> own = own_methods_of(arguments.own_method);
  std::vector<std::string> overrides;
  if (!own.empty()) overrides = overrides_of(own.front());
  overrides.insert(overrides.end(), arguments.overrides.begin(), arguments.overrides.end());
  try {
    const auto load = may_lack_robots ? avo_io::load_surroundings : avo_io::load_scenario;
    avo::Scenario scenario = load(arguments.scene, overrides, &source);
    if (!own.empty()) scenario.external = own.front().function;
    warn(source.notes);
    return scenario;
  } catch (const avo_io::OverrideError& error) {
    std::string_view message = error.what();
    for (const auto& [override, option] : arguments.typed_as) {
      const std::string set = "--set " + avo_io::printable(override, kLongestWord) + ": ";
      if (!message.starts_with(set)) continue;
      message.remove_prefix(set.size());
      const std::string key = override.substr(0, override.find('=')) + ": ";
      if (message.starts_with(key)) message.remove_prefix(key.size());
      throw avo_io::OverrideError(fmt::format("{}: {}", option, message));
    }
    throw;
  }
}

avo::Scenario load(const SceneArguments& arguments, const std::vector<NamedFile>& outputs,
                   avo_io::SceneSource* source) {
  require_distinct({file_of(arguments)}, outputs);
  avo_io::SceneSource own;
  avo_io::SceneSource& made_of = source != nullptr ? *source : own;
  avo::Scenario scenario = with_overrides(arguments, made_of);
  std::vector<NamedFile> inputs;
  for (const avo_io::SceneFile& file : made_of.files)
    if (!file.builtin) inputs.push_back({"the scene's", file.path});
  require_distinct(inputs, outputs);
  tell_settings(arguments, scenario, made_of);
  apply_remedies(arguments, scenario);
  made_of.start_at_rest = arguments.start_at_rest;
  made_of.limit_speed = arguments.limit_speed;
  require_assumptions(name_of(arguments), scenario);
  warn(avo::advice(scenario));
  return scenario;
}

int list_scenes(const std::string& name, bool json) {
  const auto& scenes = avo_io::builtin_scenes();
  if (!name.empty()) {
    for (const avo_io::BuiltinScene& scene : scenes)
      if (scene.name == name) {
        print(scene.yaml);
        return kDone;
      }
    if (const std::optional<std::string> text = avo_io::builtin_text(name)) {
      print(*text);
      return kDone;
    }
    if (const std::string_view text = avo_io::builtin_file(name); !text.empty()) {
      print(text);
      return kDone;
    }
    const auto meant = avo_io::nearest_scene(name);
    throw UsageError(fmt::format("{}: found no such scene, `avo scenes` lists them{}",
                                 avo_io::printable(name, kLongestWord),
                                 meant ? fmt::format("; did you mean \"{}\"?", *meant) : ""));
  }
  if (json) {
    auto list = nlohmann::ordered_json::array();
    for (const avo_io::BuiltinScene& scene : scenes)
      list.push_back({{"name", scene.name}, {"description", scene.description}});
    print(list.dump(2) + "\n");
    return kDone;
  }
  for (const avo_io::BuiltinScene& scene : scenes)
    print(fmt::format("{:<20} {}\n", scene.name, scene.description));
  return kDone;
}

namespace {

/// Returns a line for each robot that walls keep from its goal, with the nearest place that it can
/// reach.
std::vector<std::string> told_out_of_reach(const avo::Scenario& scenario) {
  constexpr std::size_t kNamed = 10;
  const std::vector<avo::OutOfReach> all = avo::out_of_reach(scenario);
  std::vector<std::string> lines;
  for (const avo::OutOfReach& one : std::span(all).first(std::min(kNamed, all.size()))) {
    const avo::RobotSetup& robot = scenario.robots[one.robot.value];
    lines.push_back(fmt::format(
        "robot {}: its goal [{:.9g}, {:.9g}] {}: it goes to [{:.9g}, {:.9g}], {:.3g} m from "
        "there{}",
        one.robot.value, robot.goal.x, robot.goal.y,
        one.is_in_wall
            ? fmt::format("is nearer to an obstacle than its radius = {:.9g} m", disc_radius(robot))
            : std::string("cannot be reached by any route as wide as the robot"),
        one.nearest.x, one.nearest.y, one.distance_left,
        one.counts_as_there ? ", where it has arrived" : ""));
  }
  if (all.size() > kNamed)
    lines.push_back(
        fmt::format("{} further robots cannot reach their goals either", all.size() - kNamed));
  return lines;
}

}  // namespace

int validate_scene(const SceneArguments& arguments) {
  if (const auto in_space = load_in_space(arguments, {})) {
    warn(told_out_of_reach(*in_space));
    print_results(fmt::format("{}: valid: {} robots in space, {} boxes, {} s in steps of {} s\n",
                              avo_io::printable(name_of(arguments)), in_space->robots.size(),
                              in_space->boxes.size(), in_space->duration, in_space->time_step));
    return kDone;
  }
  const avo::Scenario scenario = load(arguments);
  warn(told_out_of_reach(scenario));
  const std::size_t walls = avo::walls_of(scenario.obstacles).size();
  const std::string steps =
      scenario.clock == avo::Clock::free
          ? fmt::format("{} s by clocks of their own", scenario.duration)
          : fmt::format("{} steps of {} s", avo::last_step(scenario, scenario.duration),
                        scenario.time_step);
  print_results(fmt::format("{}: valid: {} robots, {} moving obstacles, {}{}\n",
                            avo_io::printable(name_of(arguments)), scenario.robots.size(),
                            scenario.moving_obstacles.size(),
                            walls > 0 ? fmt::format("{} walls, ", walls) : "", steps));
  return kDone;
}

int print_schema() {
  print(avo_io::scenario_schema());
  return kDone;
}

}  // namespace avo_cli
