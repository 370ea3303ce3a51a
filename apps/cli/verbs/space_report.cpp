// SPDX-License-Identifier: Apache-2.0
// avo report of a recording of space: the parts of the plane's page, and the lab or two views in
// motion.
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

#include "avo/space/metrics.h"
#include "avo/version.h"
#include "exit_codes.h"
#include "lab_page/lab_page.h"
#include "reports/html.h"
#include "reports/recording_parts.h"
#include "reports/report_parts.h"
#include "reports/report_replay.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"

namespace avo_cli {
namespace {

/// The run as one of the plane, with robots that are not always there.
avo_io::RecordedRun in_plane(const SpaceRecordingShown& shown) {
  avo_io::RecordedRun run = run_in_plane(shown.scenario, shown.frames);
  run.moments = shown.run.moments;
  for (std::size_t k = 0; k < run.frames.size(); ++k)
    run.frames[k].there = avo::figures::ViewsInPlane::twice(shown.run.frames[k].there);
  return run;
}

/// What simulating the recording again gives, or the reason why it fails.
struct SimulatedAgain {
  std::string results;  ///< HTML
  bool to_the_end = false;
};

SimulatedAgain simulated_again(const ReportArguments& arguments, const SpaceRecordingShown& shown) {
  const double end = shown.run.moments.back().time;
  const bool lasts = end > shown.scenario.duration - 0.5 * shown.scenario.time_step;
  if (shown.header.version != avo::kVersion)
    return {
        "<p>Another version of avo has made the recording, so that it is not simulated "
        "again.</p>",
        lasts};
  avo::space::Metrics metrics(shown.scenario);
  Progress progress(end);
  const avo_io::Replay replay =
      avo_io::replay_in_space(arguments.input, 0, [&](const avo::space::Simulation& simulation) {
        metrics.observe(simulation);
        progress.show(simulation.time());
      });
  if (replay.difference)
    return {
        "<p>Simulated again, the run is another one than the recording, so that there are no "
        "results of it: " +
            as_html(avo_io::readable(replay)) + "</p>",
        lasts};
  return {results_of(metrics.summary()), replay.whole};
}

std::string views_of(const SpaceRecordingShown& shown) {
  return image_of(draw_views(shown.scenario, shown.frames, "run.svg"), "plan and elevation");
}

/// Returns the replay in the lab, if the program has it; otherwise a drawing.
std::string replay_in_space_of(const std::string& recording, const avo_io::RecordedRun& run) {
  if (lab_page().empty()) return page_replay("Replay: from above, and from the side", run, 2);
  return page_lab_of(recording, run.travelers);
}

}  // namespace

std::optional<std::string> report_in_space(const ReportArguments& arguments) {
  const auto header = avo_io::read_recording_header(arguments.input);
  if (!header || !header->space) return std::nullopt;
  if (!arguments.spec.empty() || arguments.run || !arguments.line.empty() ||
      !arguments.own_methods.empty())
    throw UsageError(
        "--spec, --run, --line, --method: found with a recording of space, must be left out");
  const auto shown = space_run_of(arguments.input, {}, most_frames(2 * header->robots));
  const avo_io::Judgement judgement =
      avo_io::judge_in_space(arguments.input, shown->scenario, 1e-9, false);
  const SimulatedAgain again = simulated_again(arguments, *shown);
  const avo_io::RecordedRun run = in_plane(*shown);
  const avo_io::RecordedMoment& last = run.moments.back();
  const bool as_asked =
      again.to_the_end || (header->until_arrived && last.arrived == run.travelers);
  const std::optional<double> ended = as_asked ? std::nullopt : std::optional(last.time);
  return page_of(
      shown->scenario.name,
      fmt::format("{} robots in space, {:.6g} s", shown->scenario.robots.size(), last.time),
      {verdict_of(judgement), replay_in_space_of(arguments.input, run),
       page_figures("Figures", views_of(*shown) + "\n" + charts_of(run)),
       page_section("Results", again.results),
       page_text("What was judged", avo_io::readable(judgement)),
       page_text("Command", command_of(*header, arguments, ended)),
       page_text("Scene", scene_text_of(header->scene)),
       page_section("Made by", provenance_of(*header, arguments.input))});
}

}  // namespace avo_cli
