// SPDX-License-Identifier: Apache-2.0
// avo check: judges a recording of any origin.
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments/files.h"
#include "avo_io/judgement.h"
#include "avo_io/printable.h"
#include "avo_io/recording.h"
#include "avo_io/space.h"
#include "exit_codes.h"
#include "reports/settings_report.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

bool has_limits(const CheckArguments& arguments) {
  return arguments.radius || arguments.max_acceleration || arguments.max_speed ||
         arguments.max_braking;
}

/// Returns the scene that the recording contains, if neither another scene nor limits are given.
std::optional<avo_io::RecordedScene> own_scene(const CheckArguments& arguments) {
  if (!arguments.scene.scene.empty() || has_limits(arguments)) return std::nullopt;
  const bool may_have_one =
      avo_io::is_hdf5_path(arguments.recording) || arguments.recording.ends_with(".part");
  if (!may_have_one && !std::filesystem::exists(arguments.recording)) return std::nullopt;
  return avo_io::read_recorded_scene(arguments.recording, arguments.scene.overrides);
}

/// `scene`: whether there is a scene with robots.
void check_arguments(const CheckArguments& arguments, bool scene) {
  const std::pair<const char*, const std::optional<double>&> limits[] = {
      {"--radius", arguments.radius},
      {"--max-acceleration", arguments.max_acceleration},
      {"--max-speed", arguments.max_speed},
      {"--max-braking", arguments.max_braking}};
  for (const auto& [option, value] : limits) {
    if (scene && value)
      throw UsageError(
          fmt::format("{}: found besides the robots of --scene, must be one or the other", option));
    if (value && !(*value > 0.0))
      throw UsageError(fmt::format("{}: found {}, must be > 0", option, *value));
  }
  if (!scene && !arguments.radius)
    throw UsageError(
        "--radius: found neither it nor robots in --scene, must be one of the two; "
        "--max-acceleration "
        "and --max-speed may be with it");
  if (arguments.max_braking && !arguments.max_acceleration)
    throw UsageError("--max-braking: found without --max-acceleration, must be with it");
  if (arguments.radius && !std::isfinite(*arguments.radius))
    throw UsageError("--radius: found inf, must be finite");
  if (!scene && arguments.scene.scene.empty() && !arguments.scene.overrides.empty())
    throw UsageError("--set: found without --scene, must be with it");
  if (!scene && arguments.require_arrival)
    throw UsageError(
        "--require-arrival: found without robots of --scene, must be with them: they have goals");
}

/// What is checked of recordings of the plane and of space.
void check_common_arguments(const CheckArguments& arguments) {
  if (!(arguments.tolerance >= 0.0 && arguments.tolerance < 1.0))
    throw UsageError(
        fmt::format("--tolerance: found {}, must be >= 0 and < 1", arguments.tolerance));
  if (arguments.movers_at_rest != "ok" && arguments.movers_at_rest != "collision")
    throw UsageError(fmt::format("--movers-at-rest: found {}, must be ok or collision",
                                 avo_io::printable(arguments.movers_at_rest)));
  if (arguments.recording == "-" && arguments.scene.scene == "-")
    throw UsageError("the recording and --scene: found - twice, must be one standard input only");
  require_distinct({{"the recording", arguments.recording}, file_of(arguments.scene)}, {});
}

/// Returns the given scene, or the recording's own.
std::optional<avo::Scenario> scenario_of(const CheckArguments& arguments,
                                         const std::optional<avo_io::RecordedScene>& own) {
  if (!arguments.scene.scene.empty()) {
    avo_io::SceneSource source;
    avo::Scenario scenario = with_overrides(arguments.scene, source, true);
    tell_settings(arguments.scene, scenario, source);
    return scenario;
  }
  if (!own) return std::nullopt;
  tell_settings(arguments.scene, own->scenario, own->header.scene);
  return own->scenario;
}

avo_io::JudgeOptions options_of(const CheckArguments& arguments,
                                std::optional<avo::Scenario> scenario) {
  return {.scenario = std::move(scenario),
          .radius = arguments.radius.value_or(0.0),
          .max_acceleration = arguments.max_acceleration,
          .max_speed = arguments.max_speed,
          .max_braking = arguments.max_braking,
          .tolerance = arguments.tolerance,
          .require_arrival = arguments.require_arrival,
          .movers_at_rest = arguments.movers_at_rest == "ok"};
}

/// Judges with progress; the duration is unknown without a scene.
avo_io::Judgement judge_with_progress(const std::string& recording, avo_io::JudgeOptions options) {
  if (!options.scenario) return avo_io::judge(recording, options);
  Progress progress(options.scenario->duration, true);
  options.judged = [&progress](double time) { progress.show(time); };
  return avo_io::judge(recording, options);
}

int tell(const avo_io::Judgement& judgement, bool json) {
  if (json)
    print(avo_io::to_json(judgement));
  else
    print_results(avo_io::readable(judgement));
  if (judgement.incomplete()) return kIncomplete;
  return judgement.passed() ? kDone : kUnsafe;
}

}  // namespace

int check(const CheckArguments& arguments) {
  check_common_arguments(arguments);
  if (const auto in_space = judge_in_space(arguments)) return tell(*in_space, arguments.json);
  if (avo_io::is_space_recording(arguments.recording))
    throw UsageError(
        fmt::format("--scene: found none with space: 3, must be given: {} is a "
                    "recording of space",
                    avo_io::printable(arguments.recording)));
  const std::optional<avo_io::RecordedScene> own = own_scene(arguments);
  std::optional<avo::Scenario> scenario = scenario_of(arguments, own);
  check_arguments(arguments, scenario && !scenario->robots.empty());
  const avo_io::Judgement judgement =
      judge_with_progress(arguments.recording, options_of(arguments, std::move(scenario)));
  if (judgement.uneven_judged > 0)
    warn(
        {fmt::format("{} of {} steps are not the scene's {} s long; they are judged on the cubic "
                     "between their rows, which may not be the path",
                     judgement.uneven_judged, judgement.report.steps, *judgement.time_step)});
  if (judgement.report.without_heading > 0)
    warn(
        {fmt::format("{} of {} robot-steps are of robots without headings in the recording; their "
                     "velocities are judged, and not where they face",
                     judgement.report.without_heading, judgement.report.robot_steps)});
  return tell(judgement, arguments.json);
}

}  // namespace avo_cli
