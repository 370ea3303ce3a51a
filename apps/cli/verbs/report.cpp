// SPDX-License-Identifier: Apache-2.0
// avo report: a recording, or a sweep, as one page that needs no other file.
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

#include "arguments/files.h"
#include "arguments/measuring_line.h"
#include "arguments/own_methods.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo/version.h"
#include "avo_io/judgement.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"
#include "avo_io/replay.h"
#include "exit_codes.h"
#include "figures/trajectories.h"
#include "lab_page/lab_page.h"
#include "reports/curves.h"
#include "reports/html.h"
#include "reports/recording_parts.h"
#include "reports/report_parts.h"
#include "reports/report_replay.h"
#include "reports/sweep_report.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

/// The facts about the run that simulating the recording again gives, or the reason why it fails.
struct Again {
  std::string results;      ///< HTML
  bool to_the_end = false;  ///< whether no step of the scene was left
  bool all_arrived = false;
};

/// Returns the facts that the rows alone give.
Again told_by_rows(const avo_io::RecordedRun& run, const std::string& why) {
  const avo_io::RecordedMoment& last = run.moments.back();
  const avo::Scenario& scenario = run.scenario;
  const bool to_the_end = scenario.clock == avo::Clock::common &&
                          last_step(scenario, last.time) >= last_step(scenario, scenario.duration);
  return {"<p>" + why + "</p>", to_the_end, last.arrived == run.travelers};
}

/// Returns the run's summary from simulating it again until the recording's last time.
Again simulated_again(const ReportArguments& arguments, const avo_io::RecordingHeader& header,
                      const avo_io::RecordedRun& run,
                      const std::optional<avo::MeasuringLine>& line) {
  const avo::ExternalMethod method = method_behind(arguments.own_methods, run.scenario);
  if (!method && has_external(run.scenario))
    return told_by_rows(run, "Without --method the run is not simulated again: it is by " +
                                 as_html(run.scenario.external_method) +
                                 ", a method of its maker's own.");
  if (header.version != avo::kVersion)
    return told_by_rows(run,
                        "Another version of avo has made the recording, so that it is not "
                        "simulated again.");
  if (const auto lost = avo_io::lost_setting(header.scene))
    return told_by_rows(run, as_html(*lost) +
                                 " was removed from avo, so that the run cannot be "
                                 "simulated again.");
  avo::Metrics metrics(run.scenario, {.crowd = false, .line = line});
  Progress progress(run.moments.back().time);
  const avo_io::Replay replay = avo_io::replay(
      arguments.input, 0,
      [&](const avo::Simulation& simulation) {
        metrics.observe(simulation);
        progress.show(simulation.time());
      },
      method);
  if (replay.difference)
    return told_by_rows(run,
                        "Simulated again, the run is another one than the recording, so that there "
                        "are no results of it: " +
                            as_html(avo_io::readable(replay)));
  return {results_of(metrics.summary()), replay.whole, metrics.all_arrived()};
}

std::string figures_of(const avo_io::RecordedRun& run) {
  return image_of(draw_trajectories(run.scenario, frames_of(run), "run.svg"), "trajectories") +
         "\n" + charts_of(run);
}

/// Returns the replay in the lab, if the program has it; otherwise a drawing.
std::string replay_of(const std::string& recording, const avo_io::RecordedRun& run) {
  if (lab_page().empty()) return page_replay("Replay", run);
  return page_lab_of(recording, static_cast<std::int64_t>(run.scenario.robots.size()));
}

/// Returns the command that made the recording. The motion of another program has none.
std::string made_by(const avo_io::RecordingHeader& header, const ReportArguments& arguments,
                    const avo::Scenario& scenario, std::optional<double> ended) {
  const bool by_others =
      has_external(scenario) && arguments.own_methods.empty() && !header.state_hash;
  if (!by_others) return command_of(header, arguments, ended);
  return fmt::format("avo convert MOTION {} --to recording{}", arguments.input,
                     set_options(header.scene.overrides));
}

std::string recording_page(const ReportArguments& arguments) {
  const std::optional<avo::MeasuringLine> line = line_of(arguments.line);
  if (!arguments.spec.empty() || arguments.run)
    throw UsageError(fmt::format("{}: found with a recording, must be with a table of avo sweep",
                                 arguments.run ? "--run" : "--spec"));
  const auto found = avo_io::read_recording_header(arguments.input);
  if (!found)
    throw avo_io::RecordingError(arguments.input +
                                 ": found no scene in it, must be a recording as HDF5");
  const avo_io::RecordingHeader& header = *found;
  const avo_io::RecordedRun run = avo_io::read_run(arguments.input, most_frames(header.robots));
  const avo::Scenario& scenario = run.scenario;
  const avo_io::Judgement judgement = avo_io::judge(arguments.input, {.scenario = scenario});
  const Again again = simulated_again(arguments, header, run, line);
  const double end = run.moments.back().time;
  const bool as_asked = again.to_the_end || (header.until_arrived && again.all_arrived);
  return page_of(scenario.name,
                 fmt::format("{} robots, method {}, {:.6g} s", scenario.robots.size(),
                             method_name(scenario), judgement.report.to),
                 {verdict_of(judgement), replay_of(arguments.input, run),
                  page_figures("Figures", figures_of(run)), page_section("Results", again.results),
                  page_text("What was judged", avo_io::readable(judgement)),
                  page_text("Command", made_by(header, arguments, scenario,
                                               as_asked ? std::nullopt : std::optional(end))),
                  page_text("Scene", scene_text_of(header.scene)),
                  page_section("Made by", provenance_of(header, arguments.input))});
}

}  // namespace

int report(const ReportArguments& arguments) {
  catch_signals(Patience::none);
  require_ending({"the report", arguments.output}, {".html"});
  require_distinct({{"the input", arguments.input}, {"--spec", arguments.spec}},
                   {{"the report", arguments.output}});
  if (!arguments.line.empty() && is_sweep_table(arguments.input))
    throw UsageError(
        "--line: found with a table of avo sweep, must be with a recording; the flow of a sweep is "
        "measured where its file has the key \"line\"");
  avo_io::OutputFile file(arguments.output);
  if (is_sweep_table(arguments.input))
    file.write(sweep_page(arguments));
  else if (const auto in_space = report_in_space(arguments))
    file.write(*in_space);
  else
    file.write(recording_page(arguments));
  file.commit();
  if (arguments.output != "-") print_results(arguments.output + "\n");
  return kDone;
}

}  // namespace avo_cli
