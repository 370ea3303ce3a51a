// SPDX-License-Identifier: Apache-2.0
#include "reports/recording_parts.h"

#include <fmt/format.h>
#include <utility>
#include <vector>

#include "figures/chart.h"
#include "figures/colors.h"
#include "reports/curves.h"
#include "reports/html.h"
#include "reports/report_parts.h"

namespace avo_cli {
namespace {

namespace figures = avo::figures;

std::string chart_of(const std::string& y_label, const std::vector<avo::Vec2>& points,
                     figures::Color color, const std::string& words,
                     std::optional<double> y_most = {}) {
  if (points.empty()) return "";
  const figures::Chart chart{"t (s)", y_label, {{words, points, color, false}}, y_most};
  return image_of(draw_chart(chart, "chart.svg"), words);
}

}  // namespace

std::string verdict_of(const avo_io::Judgement& judgement) {
  const char* word = judgement.incomplete() ? "incomplete" : judgement.safe() ? "safe" : "unsafe";
  return fmt::format("<p><span class=\"verdict {0}\">{0}</span></p>\n", word);
}

std::string results_of(const avo::RunSummary& summary) {
  auto told = nlohmann::ordered_json::parse(avo_io::to_json(summary));
  if (summary.metrics.crossing_times) {
    told["metrics"]["crossings"] = summary.metrics.crossing_times->size();
    told["metrics"].erase("crossing_times");
  }
  return table_of(told);
}

std::string charts_of(const avo_io::RecordedRun& run) {
  return chart_of("clearance (m)", clearances_of(run), figures::kPurple,
                  "least clearance of all robots") +
         "\n" +
         chart_of("arrived (%)", arrivals_of(run), figures::kGreen, "robots that have arrived",
                  100.0) +
         "\n" + chart_of("speed (m/s)", top_speeds_of(run), figures::kVermilion, "fastest robot");
}

std::string scene_text_of(const avo_io::SceneSource& scene) {
  std::string text = scene.yaml;
  for (const avo_io::SceneFile& file : scene.files)
    text += fmt::format("\n# {}: {} bytes, in the recording\n", file.path, file.text.size());
  return text;
}

std::string provenance_of(const avo_io::RecordingHeader& header, const std::string& recording) {
  std::vector<std::pair<std::string, std::string>> rows{{"avo", header.version},
                                                        {"build", header.build},
                                                        {"seed", std::to_string(header.seed)},
                                                        {"recording", recording}};
  if (header.state_hash)
    rows.emplace_back("state hash", fmt::format("{:#018x}", *header.state_hash));
  return table_of(rows);
}

std::string command_of(const avo_io::RecordingHeader& header, const ReportArguments& arguments,
                       std::optional<double> ended) {
  std::string command = "avo run " + shell_word(header.scene.name);
  command += set_options(header.scene.overrides);
  for (const std::string& own : arguments.own_methods) command += " --method " + shell_word(own);
  if (header.scene.start_at_rest) command += " --start-at-rest";
  if (header.scene.limit_speed) command += " --limit-speed";
  if (header.every > 1) command += fmt::format(" --every {}", header.every);
  if (header.until_arrived) command += " --until-arrived";
  if (ended) command += fmt::format(" --duration {}", *ended);  // e.g. by a signal
  return command + " --record " + shell_word(arguments.input);
}

}  // namespace avo_cli
