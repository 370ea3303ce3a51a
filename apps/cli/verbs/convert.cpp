// SPDX-License-Identifier: Apache-2.0
// avo convert: recordings for other programs.
#include "avo_io/convert.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/files.h"
#include "avo_io/nearest.h"
#include "avo_io/printable.h"
#include "avo_io/recording.h"
#include "avo_io/sweep.h"
#include "exit_codes.h"
#include "reports/settings_report.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

using avo_io::ExportFormat;

/// An ending of an output's name. The endings of recordings and of text do not determine the
/// format.
struct Ending {
  std::string_view ending;
  ExportFormat format;
};
constexpr Ending kEndings[] = {{".csv", ExportFormat::csv},
                               {".sqlite", ExportFormat::sqlite},
                               {".h5", ExportFormat::pedestrian_hdf5},
                               {".h5", ExportFormat::recording},
                               {".mcap", ExportFormat::mcap},
                               {".glb", ExportFormat::gltf},
                               {".txt", ExportFormat::pedestrian_text},
                               {".txt", ExportFormat::obsmat}};

ExportFormat format_called(const std::string& word) {
  std::vector<std::string_view> words;
  for (const auto& [name, format] : avo_io::kExportFormats) {
    if (name == word) return format;
    words.push_back(name);
  }
  words.emplace_back(kSetPoints);
  throw UsageError(fmt::format("--to: found {}, {}", avo_io::printable(word, kLongestWord),
                               avo_io::allowed_words(word, words)));
}

ExportFormat format_of(const ConvertArguments& arguments) {
  if (!arguments.to.empty()) {
    const ExportFormat format = format_called(arguments.to);
    for (const Ending& known : kEndings)
      if (known.format == format) require_ending({"the output", arguments.output}, {known.ending});
    return format;
  }
  const std::string ending = std::filesystem::path(arguments.output).extension().string();
  if (ending == ".h5" || ending == ".txt")
    throw UsageError(fmt::format(
        "the output {}: found the ending {} without --to, must be with --to {}", arguments.output,
        ending, ending == ".h5" ? "recording or pedestrian-hdf5" : "pedestrian-text or obsmat"));
  for (const Ending& known : kEndings)
    if (ending == known.ending) return known.format;
  throw UsageError(
      fmt::format("the output {}: found the ending \"{}\", must be .csv, .sqlite, .mcap or .glb, "
                  "or with --to FORMAT",
                  arguments.output, avo_io::printable(ending, kLongestWord)));
}

/// Changes to a scene for a recording of another program. Its robots have a method of their own,
/// which cannot be asked again. --set may still change it.
std::vector<std::string> of_another_method(const ConvertArguments& arguments) {
  const std::string stem = std::filesystem::path(arguments.recording).stem().string();
  const avo_io::OwnMethod method{.name = arguments.name.empty() ? stem : arguments.name,
                                 .function = {},
                                 .clamped = false,
                                 .certified = false,
                                 .version = ""};
  std::vector<std::string> changes = overrides_of(method);
  const std::vector<std::string>& given = arguments.scene.overrides;
  changes.insert(changes.end(), given.begin(), given.end());
  return changes;
}

void tell_motion_scene(const avo_io::MotionScene& made, double radius, bool has_walls) {
  std::string line = fmt::format(
      "the robots are made of the motion: the first place, the last one as goal, the largest speed "
      "and acceleration; radius {} m (--radius)",
      radius);
  if (made.robots.back() != std::ssize(made.robots) - 1)
    line += fmt::format(", robot 0 is {} there, robot {} is {}", made.robots.front(),
                        made.robots.size() - 1, made.robots.back());
  if (made.first_time != 0.0) line += fmt::format(", 0 s is {} s there", made.first_time);
  if (!has_walls) line += "; nobody knows of walls, --scene gives them";
  warn({line});
}

/// Takes the robots from the motion, where --scene has none. surroundings: of --scene, if any.
void take_robots(const ConvertArguments& arguments, const avo_io::SceneSource& surroundings,
                 avo_io::ConvertOptions& options) {
  if (arguments.recording == "-")
    throw UsageError(
        "the recording: found the standard input, must be a file where --scene has no robots");
  if (surroundings.yaml.empty() && avo_io::read_recording_header(arguments.recording))
    throw UsageError("--scene: found none, must be given: " + arguments.recording +
                     " is a recording with a scene of its own");
  const double radius = arguments.radius.value_or(kRadiusOfPeople);
  if (!(radius > 0.0) || !std::isfinite(radius))
    throw UsageError(fmt::format("--radius: found {}, must be > 0 m and finite", radius));
  avo_io::MotionScene made = avo_io::scene_of_motion(arguments.recording, surroundings, radius);
  for (const std::string& change : of_another_method(arguments))
    made.source.overrides.push_back(change);
  options.scenario = avo_io::parse_scenario(made.source);
  tell_motion_scene(made, radius, !options.scenario->obstacles.empty());
  options.source = made.source;
  options.robots = made.robots, options.first_time = made.first_time;
}

/// The scene and the robots of a recording that is made.
void take_scene(const ConvertArguments& arguments, avo_io::ConvertOptions& options) {
  avo_io::SceneSource surroundings;
  const bool has_robots =
      !arguments.scene.scene.empty() &&
      !avo_io::load_surroundings(arguments.scene.scene, {}, &surroundings).robots.empty();
  if (!has_robots) return take_robots(arguments, surroundings, options);
  if (arguments.radius)
    throw UsageError("--radius: found with robots in --scene, must be without them");
  SceneArguments scene = arguments.scene;
  scene.overrides = of_another_method(arguments);
  options.scenario = with_overrides(scene, options.source);
}

/// Returns the scene of --scene, or the scene in the recording, with the overrides.
std::optional<avo::Scenario> scenario_of(const ConvertArguments& arguments,
                                         avo_io::SceneSource& source) {
  if (!arguments.scene.scene.empty()) {
    avo::Scenario scenario = with_overrides(arguments.scene, source, true);
    tell_settings(arguments.scene, scenario, source);
    return scenario;
  }
  auto own = avo_io::read_recorded_scene(arguments.recording, arguments.scene.overrides);
  if (!own) {
    if (!arguments.scene.overrides.empty())
      throw UsageError("--set: found without --scene, must be with it");
    return std::nullopt;
  }
  return std::move(own->scenario);
}

/// Says where the starts of a recording differ from those of the scene.
std::string told(const std::vector<avo_io::OtherStart>& starts) {
  const avo_io::OtherStart& first = starts.front();
  const std::string place = first.found
                                ? fmt::format("is at [{}, {}]", first.found->x, first.found->y)
                                : std::string("has no row at the first time");
  const std::string more =
      starts.size() > 1 ? fmt::format(", and {} more are elsewhere", starts.size() - 1) : "";
  return fmt::format(
      "robot {} {}, and the scene has it start at [{}, {}]{}: is it the scene of the "
      "recording?",
      first.robot, place, first.start.x, first.start.y, more);
}

void report(const ConvertArguments& arguments, const avo_io::Converted& converted) {
  std::vector<std::string> warnings;
  if (converted.left_out)
    warnings.push_back(fmt::format("the last time, {} s, is left out: it is between two frames",
                                   *converted.left_out));
  if (converted.without_walls)
    warnings.push_back(
        "there is no scene, and nobody knows of walls: the walkable area is a rectangle around all "
        "motion; --scene gives one");
  if (!converted.other_starts.empty()) warnings.push_back(told(converted.other_starts));
  if (!warnings.empty()) warn(warnings);
  if (arguments.output == "-") return;
  print_results(fmt::format(
      "{}: {} times, {} rows{}\n", arguments.output, converted.times, converted.rows,
      converted.fps ? fmt::format(", {} frames a second", *converted.fps) : std::string()));
}

}  // namespace

int convert(const ConvertArguments& arguments) {
  catch_signals(Patience::none);
  if (arguments.to == kSetPoints) return convert_to_set_points(arguments);
  if (arguments.rate) throw UsageError("--rate: found without --to set-points, must be with it");
  if (!arguments.autopilot.empty())
    throw UsageError("--autopilot: found without --to set-points, must be with it");
  const ExportFormat format = format_of(arguments);
  if (arguments.recording == "-" && arguments.scene.scene == "-")
    throw UsageError("the recording and --scene: found - twice, must be one standard input only");
  require_distinct({{"the recording", arguments.recording}, file_of(arguments.scene)},
                   {{"the output", arguments.output}});
  if (!arguments.name.empty() && format != ExportFormat::recording)
    throw UsageError("--name: found without --to recording, must be with it");
  if (arguments.radius && format != ExportFormat::recording)
    throw UsageError("--radius: found without --to recording, must be with it");
  if (const auto in_space = convert_in_space(arguments, format)) {
    report(arguments, *in_space);
    return kDone;
  }
  avo_io::ConvertOptions options{.format = format};
  if (format == ExportFormat::recording)
    take_scene(arguments, options);
  else
    options.scenario = scenario_of(arguments, options.source);
  if (format == ExportFormat::mcap && options.scenario && options.scenario->robots.empty())
    throw UsageError("--scene: found no robots in it, must have them: MCAP shows radii");
  if (format == ExportFormat::mcap && !options.scenario) {
    if (arguments.recording != "-") avo_io::RecordingReader(arguments.recording);  // does it exist?
    throw UsageError(
        "--scene: found none, must be given: MCAP shows radii and walls, and CSV has neither");
  }
  std::optional<Progress> progress;
  if (options.scenario) progress.emplace(options.scenario->duration, true);
  if (progress) options.converted = [&progress](double time) { progress->show(time); };
  report(arguments, avo_io::convert(arguments.recording, arguments.output, options));
  return kDone;
}

}  // namespace avo_cli
