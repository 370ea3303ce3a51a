// SPDX-License-Identifier: Apache-2.0
// avo run: simulates a scene to its end, and writes the requested outputs.
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments/files.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"
#include "exit_codes.h"
#include "figures/trajectories.h"
#include "reports/run_report.h"
#include "reports/settings_report.h"
#include "system/signals.h"
#include "verbs/run_loop.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

constexpr double kSlack = 1e-9;  // s: times of steps are rounded

std::vector<NamedFile> files_of(const RunArguments& arguments) {
  return {{"--record", arguments.record},
          {"--summary", arguments.summary},
          {"--figure", arguments.figure}};
}

/// All outputs of a run. They are opened before the simulation, so that an unwritable place is
/// reported at once; they get their names after it.
struct Outputs {
  std::unique_ptr<avo_io::Recording> record;
  std::optional<avo_io::OutputFile> summary, figure;
  std::optional<avo::figures::TrajectoryRecorder> trajectories;
  std::string figure_path;
  TimeWindow shown;          ///< by the figure
  double time_of_end = 0.0;  ///< s
  avo::figures::FigureOptions figure_options;
  std::int64_t every;  ///< steps between rows of the recording

  Outputs(const RunArguments& arguments, const avo::Scenario& scenario,
          const avo_io::SceneSource& source)
      : figure_path(arguments.figure),
        shown(arguments.figure_time.value_or(TimeWindow{})),
        every(arguments.every.value_or(1)) {
    const FigureSize size = arguments.figure_size.value_or(FigureSize{});
    figure_options.width = size.width, figure_options.height = size.height;
    figure_options.robots = arguments.figure_robots;
    if (!arguments.figure.empty()) {
      figure.emplace(arguments.figure);
      trajectories.emplace();
    }
    if (!arguments.summary.empty()) summary.emplace(arguments.summary);
    if (!arguments.record.empty())
      record = avo_io::open_recording(arguments.record, scenario, source,
                                      {.every = every, .until_arrived = arguments.until_arrived});
  }

  /// Call it at the start and after each step.
  void observe(const avo::Simulation& simulation) {
    if (record && simulation.steps() % every == 0) record->add(simulation);
    if (trajectories && simulation.time() >= shown.from - kSlack &&
        simulation.time() <= shown.to + kSlack)
      trajectories->observe(simulation);
  }

  /// Call it after the last step.
  void observe_last(const avo::Simulation& simulation) {
    time_of_end = simulation.time();
    if (!record) return;
    if (simulation.steps() % every != 0) record->add(simulation);
    record->finish(simulation);
  }

  /// Draws the figure, and adds its file. Without a moment to show there is none.
  void draw(const avo::Scenario& scenario, std::vector<avo_io::OutputFile*>& files) {
    const std::vector<avo::figures::TrajectoryFrame> frames = trajectories->frames();
    if (frames.empty() && signal_caught() != 0) return;
    if (frames.empty())
      throw UsageError(
          fmt::format("--figure-time: found {:.6g} s, must be before the run's end, at {:.6g} s",
                      shown.from, time_of_end));
    files.push_back(&*figure);
    figure->write(
        drawn([&] { return draw_trajectories(scenario, frames, figure_path, figure_options); }));
  }

  /// Finishes all outputs, or none if one cannot be written. A figure can take longer to draw than
  /// a signal allows, so the other outputs are finished first.
  void finish(const avo::Scenario& scenario, const avo::RunSummary& results) {
    std::vector<avo_io::OutputFile*> files;
    if (record) files.push_back(&record->file());
    if (summary) files.push_back(&*summary);
    if (summary) summary->write(avo_io::to_json(results));
    if (signal_caught() != 0) commit_all(files);
    if (figure) draw(scenario, files);
    commit_all(files);
  }
};

avo::RunSummary simulate(const RunArguments& arguments, const avo::Scenario& scenario,
                         Outputs& outputs) {
  avo::Simulation simulation(scenario, arguments.threads);
  tell_machine(simulation);
  return simulate_to_end(arguments, scenario.duration, simulation, avo::Metrics(scenario), outputs);
}

void check_arguments(const RunArguments& arguments) {
  require_ending({"--record", arguments.record}, {".csv", ".h5"});
  require_ending({"--summary", arguments.summary}, {".json"});
  require_figure({"--figure", arguments.figure});
  if (arguments.every && arguments.record.empty())
    throw UsageError("--every: found without --record, must be with it: it thins the recording");
}

/// Refuses a window behind the end of the run, and robots that are not there.
void check_figure(const RunArguments& arguments, const avo::Scenario& scenario) {
  if (arguments.figure_time && arguments.figure_time->from > scenario.duration)
    throw UsageError(
        fmt::format("--figure-time: found a begin at {:.6g} s, must be <= {:.6g} s, the duration",
                    arguments.figure_time->from, scenario.duration));
  if (!arguments.figure_robots.empty() && arguments.figure_robots.back() >= scenario.robots.size())
    throw UsageError(fmt::format("--figure-robots: found {}, must be < {}, the number of robots",
                                 arguments.figure_robots.back(), scenario.robots.size()));
}

}  // namespace

int tell_run(const RunArguments& arguments, const std::string& results, const std::string& steps) {
  if (arguments.record != "-" && arguments.summary != "-")
    print_results(results);
  else if (volume() != Volume::quiet)
    say(lines_of(results));
  const int caught = signal_caught();
  if (caught == 0) return kDone;
  say(fmt::format("stopped by a signal after {}; all outputs end there", steps));
  return kSignal + caught;
}

int run(const RunArguments& arguments) {
  check_arguments(arguments);
  catch_signals();
  avo_io::SceneSource source;
  if (const auto in_space = load_in_space(arguments.scene, files_of(arguments), &source))
    return run_in_space(arguments, *in_space, source);
  const avo::Scenario scenario = load(arguments.scene, files_of(arguments), &source);
  check_figure(arguments, scenario);
  Outputs outputs(arguments, scenario, source);
  const avo::RunSummary results = simulate(arguments, scenario, outputs);
  outputs.finish(scenario, results);
  tell_unreachable(results);
  const std::string steps = scenario.clock == avo::Clock::free
                                ? fmt::format("{} steps", results.steps)
                                : fmt::format("{} of {} steps", results.steps,
                                              avo::last_step(scenario, scenario.duration));
  return tell_run(arguments, readable(scenario, results), steps);
}

}  // namespace avo_cli
