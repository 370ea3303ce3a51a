// SPDX-License-Identifier: Apache-2.0
// avo run, check, replay and convert for scenes of space.
#include "verbs/space_verbs.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "arguments/files.h"
#include "avo/space/metrics.h"
#include "avo/space/reachability.h"
#include "avo_io/nearest.h"
#include "avo_io/output_file.h"
#include "avo_io/printable.h"
#include "avo_io/recording.h"
#include "avo_io/space_decision.h"
#include "exit_codes.h"
#include "figures/space_views.h"
#include "reports/run_report.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/run_loop.h"

namespace avo_cli {
namespace {

/// All outputs of a run. They are opened before the simulation, and get their names after it.
struct SpaceOutputs {
  std::unique_ptr<avo_io::SpaceRecording> record;
  std::int64_t every;  ///< steps between rows of the recording
  std::optional<avo_io::OutputFile> summary, figure;
  avo::figures::SpaceRecorder frames;

  SpaceOutputs(const RunArguments& arguments, const avo::space::Scenario& scenario,
               const avo_io::SceneSource& source)
      : every(arguments.every.value_or(1)) {
    if (!arguments.record.empty())
      record =
          avo_io::open_space_recording(arguments.record, scenario, source,
                                       {.every = every, .until_arrived = arguments.until_arrived});
    if (!arguments.summary.empty()) summary.emplace(arguments.summary);
    if (!arguments.figure.empty()) figure.emplace(arguments.figure);
  }
  void observe(const avo::space::Simulation& simulation) {
    if (record && simulation.steps() % every == 0) record->add(simulation);
    if (figure) frames.observe(simulation);
  }
  /// Call it after the last step.
  void observe_last(const avo::space::Simulation& simulation) {
    if (!record) return;
    if (simulation.steps() % every != 0) record->add(simulation);
    record->finish(simulation);
  }
  void draw(const RunArguments& arguments, const avo::space::Scenario& scenario) {
    const FigureSize size = arguments.figure_size.value_or(FigureSize{});
    avo::figures::FigureOptions options;
    options.width = size.width, options.height = size.height;
    options.robots = arguments.figure_robots;
    if (!options.robots.empty() && options.robots.back() >= scenario.robots.size())
      throw UsageError(fmt::format("--figure-robots: found {}, must be < {}, the number of robots",
                                   options.robots.back(), scenario.robots.size()));
    const TimeWindow shown = arguments.figure_time.value_or(TimeWindow{});
    std::vector<avo::figures::SpaceRecorder::Frame> kept = frames.frames();
    std::erase_if(
        kept, [&](const auto& frame) { return frame.time < shown.from || frame.time > shown.to; });
    if (kept.empty())
      throw UsageError(
          fmt::format("--figure-time: found {:.6g} s, must be before the run's end", shown.from));
    figure->write(
        drawn([&] { return avo::figures::draw_views(scenario, kept, arguments.figure, options); }));
  }
  void finish(const RunArguments& arguments, const avo::space::Scenario& scenario,
              const avo::RunSummary& results) {
    std::vector<avo_io::OutputFile*> files;
    if (record) files.push_back(&record->file());
    if (summary) files.push_back(&*summary), summary->write(avo_io::to_json(results));
    if (figure) {
      draw(arguments, scenario);
      files.push_back(&*figure);
    }
    commit_all(files);
  }
};

/// Returns the scene of space that the recording contains, if it contains one.
std::optional<avo_io::RecordedSpaceScene> own_scene(const std::string& recording,
                                                    const SceneArguments& arguments) {
  std::error_code error;  // what cannot be read is refused where it is read
  if (!std::filesystem::is_regular_file(recording, error)) return std::nullopt;
  return avo_io::read_recorded_space_scene(recording, arguments.overrides);
}

/// Returns the scene of --scene if it is one of space, or else that of the recording.
std::optional<avo_io::RecordedSpaceScene> scene_of(const std::string& recording,
                                                   const SceneArguments& arguments) {
  avo_io::RecordedSpaceScene found;
  if (auto given = load_in_space(arguments, {}, &found.header.scene)) {
    found.scenario = std::move(*given);
    return found;
  }
  if (!arguments.scene.empty()) return std::nullopt;
  return own_scene(recording, arguments);
}

}  // namespace

std::vector<std::string> told_out_of_reach(const avo::space::Scenario& scenario) {
  constexpr std::size_t kNamed = 10;
  const std::vector<avo::space::OutOfReach> all = out_of_reach(scenario);
  std::vector<std::string> lines;
  for (const avo::space::OutOfReach& one : std::span(all).first(std::min(kNamed, all.size()))) {
    const avo::space::RobotSetup& robot = scenario.robots[one.robot.value];
    lines.push_back(fmt::format(
        "robot {}: its goal [{:.9g}, {:.9g}, {:.9g}] {}: it goes to [{:.9g}, {:.9g}, {:.9g}], "
        "{:.3g} m from there",
        one.robot.value, robot.goal.x, robot.goal.y, robot.goal.z,
        one.is_in_box ? fmt::format("is nearer to an obstacle than its radius = {:.9g} m",
                                    robot_of(robot).radius)
                      : std::string("cannot be reached by any route as wide as the robot"),
        one.nearest.x, one.nearest.y, one.nearest.z, one.distance_left));
  }
  if (all.size() > kNamed)
    lines.push_back(
        fmt::format("{} further robots cannot reach their goals either", all.size() - kNamed));
  return lines;
}

std::optional<avo::space::Scenario> load_in_space(const SceneArguments& arguments,
                                                  const std::vector<NamedFile>& outputs,
                                                  avo_io::SceneSource* source) {
  if (arguments.scene.empty()) return std::nullopt;
  std::optional<avo::space::Scenario> scenario =
      avo_io::load_space_scenario(arguments.scene, arguments.overrides, source);
  if (!scenario) return std::nullopt;
  require_distinct({file_of(arguments)}, outputs);
  if (!arguments.own_method.empty())
    throw UsageError("--method: found with a scene of space, which has method avo alone");
  if (arguments.start_at_rest || arguments.limit_speed)
    throw UsageError(
        "--start-at-rest, --limit-speed: found one of them with a scene of space, must be left out");
  return scenario;
}

int run_in_space(const RunArguments& arguments, const avo::space::Scenario& scenario,
                 const avo_io::SceneSource& source) {
  SpaceOutputs outputs(arguments, scenario, source);
  avo::space::Simulation simulation(scenario, arguments.threads);
  const avo::RunSummary results = simulate_to_end(arguments, scenario.duration, simulation,
                                                  avo::space::Metrics(scenario), outputs);
  outputs.finish(arguments, scenario, results);
  tell_unreachable(results);
  avo::Scenario named;  // what the text says of the scene
  named.name = scenario.name;
  named.time_step = scenario.time_step;
  named.duration = scenario.duration;
  return tell_run(arguments, readable(named, results), fmt::format("{} steps", results.steps));
}

int explain_in_space(const ExplainArguments& arguments, const avo::space::Scenario& scenario) {
  if (!arguments.figure.empty() || !arguments.states.empty())
    throw UsageError("--figure, --states: found one of them with a scene of space, must be left out");
  Progress progress(arguments.time);  // wiped before other output
  const auto decision = [&] {
    try {
      return avo_io::explain_in_space(scenario, arguments.robot, arguments.time, 0,
                                      [&progress](double time) {
                                        progress.show(time);
                                        return signal_caught() == 0;
                                      });
    } catch (const avo::Error& error) {
      const std::string what = error.what();
      const bool is_option = what.starts_with("robot:") || what.starts_with("time:");
      throw UsageError((is_option ? "--" : "") + what);
    }
  }();
  if (!decision) return kSignal + signal_caught();
  if (arguments.json)
    print(avo_io::to_json(*decision, scenario.name));
  else
    print_results(avo_io::readable(*decision, scenario.name));
  return kDone;
}

std::optional<avo_io::Judgement> judge_in_space(const CheckArguments& arguments) {
  const auto scene = scene_of(arguments.recording, arguments.scene);
  if (!scene) return std::nullopt;
  if (arguments.radius || arguments.max_acceleration || arguments.max_speed ||
      arguments.max_braking)
    throw UsageError(
        "--radius, --max-acceleration, --max-speed, --max-braking: found besides the robots of "
        "--scene, must be one or the other");
  return avo_io::judge_in_space(arguments.recording, scene->scenario, arguments.tolerance,
                                arguments.require_arrival, arguments.movers_at_rest == "ok");
}

std::optional<SpaceRecordingShown> space_run_of(const std::string& recording,
                                                const SceneArguments& scene,
                                                std::size_t most_frames) {
  auto found = scene_of(recording, scene);
  if (!found) return std::nullopt;
  SpaceRecordingShown shown{std::move(found->header), std::move(found->scenario), {}, {}};
  shown.run = avo_io::read_space_run(recording, shown.scenario, most_frames);
  for (const avo_io::SpaceFrame& frame : shown.run.frames)
    shown.frames.push_back(
        {frame.time, frame.position, avo::figures::movers_at(shown.scenario, frame.time)});
  return shown;
}

std::optional<avo_io::Replay> replay_in_space(const ReplayArguments& arguments) {
  const auto own = own_scene(arguments.recording, {});
  if (!own) return std::nullopt;
  if (!arguments.own_method.empty())
    throw UsageError("--method: found with a recording of space, which has method avo alone");
  Progress progress(own->scenario.duration, true);
  return avo_io::replay_in_space(
      arguments.recording, arguments.threads,
      [&progress](const avo::space::Simulation& run) { progress.show(run.time()); });
}

std::optional<avo_io::Converted> convert_in_space(const ConvertArguments& arguments,
                                                  avo_io::ExportFormat format) {
  const auto scene = scene_of(arguments.recording, arguments.scene);
  if (!scene && (arguments.recording == "-" || !arguments.scene.scene.empty() ||
                 !avo_io::is_space_recording(arguments.recording)))
    return std::nullopt;
  using avo_io::ExportFormat;
  const bool is_of_space = format == ExportFormat::csv || format == ExportFormat::recording ||
                           format == ExportFormat::mcap || format == ExportFormat::gltf;
  if (!is_of_space)
    throw UsageError(
        "the output: found a format of the plane, must be csv, recording, mcap, gltf or set-points "
        "for a recording of space");
  if (!scene && format != ExportFormat::csv)
    throw UsageError(
        "--scene: found none, must be given: the format has radii and boxes, and CSV has neither");
  return avo_io::convert_in_space(arguments.recording, arguments.output,
                                  {.format = format, .scene = scene});
}

namespace {

avo_io::Autopilot autopilot_called(const std::string& word) {
  if (word.empty()) return avo_io::Autopilot::any;
  if (word == "px4") return avo_io::Autopilot::px4;
  if (word == "crazyflie") return avo_io::Autopilot::crazyflie;
  throw UsageError(fmt::format("--autopilot: found {}, {}", avo_io::printable(word, kLongestWord),
                               avo_io::allowed_words(word, {"px4", "crazyflie"})));
}

}  // namespace

int convert_to_set_points(const ConvertArguments& arguments) {
  constexpr double kUsualRate = 50.0;  // Hz
  require_ending({"the output", arguments.output}, {".csv"});
  require_distinct({{"the recording", arguments.recording}, file_of(arguments.scene)},
                   {{"the output", arguments.output}});
  if (!arguments.name.empty())
    throw UsageError("--name: found without --to recording, must be with it");
  const avo_io::Autopilot autopilot = autopilot_called(arguments.autopilot);
  const auto scene = scene_of(arguments.recording, arguments.scene);
  if (!scene)
    throw UsageError("--scene: found no scene with space: 3, must be given with --to set-points");
  const std::int64_t rows =
      avo_io::write_set_points(arguments.recording, arguments.output, scene->scenario,
                               arguments.rate.value_or(kUsualRate), autopilot);
  if (arguments.output != "-") print_results(fmt::format("{}: {} rows\n", arguments.output, rows));
  return kDone;
}

}  // namespace avo_cli
