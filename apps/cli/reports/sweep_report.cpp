// SPDX-License-Identifier: Apache-2.0
// avo report for a sweep: its table as one page, with one of its runs in motion.
#include "reports/sweep_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "arguments/own_methods.h"
#include "avo/version.h"
#include "avo_io/printable.h"
#include "avo_io/space.h"
#include "avo_io/sweep.h"
#include "exit_codes.h"
#include "figures/space_views.h"
#include "figures/trajectories.h"
#include "lab_page/lab_page.h"
#include "reports/comparison.h"
#include "reports/html.h"
#include "reports/report_parts.h"
#include "reports/report_replay.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

constexpr std::size_t kMostFigures = 24;  // figures of arrivals: a page of some megabytes
constexpr const char* kPageColumns[] = {
    "all_arrived",      "success",       "collided",
    "collision_pairs",  "min_clearance", "last_arrival",
    "extra_time_mean",  "path_ratio",    "effort",
    "acceleration_rms", "jerk",          "reversals",
    "turned_back",      "deadlock_time", "step_milliseconds_median"};

/// Returns the distinct values in one column of a table.
std::set<std::string> values_in(const avo_io::SweepTable& table, const std::string& column) {
  const auto at = std::find(table.columns.begin(), table.columns.end(), column);
  std::set<std::string> values;
  if (at == table.columns.end()) return values;
  for (const std::vector<std::string>& row : table.rows)
    values.insert(row[static_cast<std::size_t>(at - table.columns.begin())]);
  return values;
}

/// Returns "1 scene", "3 scenes".
std::string counted(std::size_t number, const std::string& thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string subtitle_of(const avo_io::SweepTable& table) {
  std::string text = fmt::format("{}: {}, {}", counted(table.rows.size(), "run"),
                                 counted(values_in(table, "scene").size(), "scene"),
                                 counted(values_in(table, "method").size(), "method"));
  const auto [first, last] = avo_io::parameters_of(table);
  for (std::size_t c = first; c < last; ++c)
    text += fmt::format(", {} of {}", counted(values_in(table, table.columns[c]).size(), "value"),
                        table.columns[c]);
  return text + ", " + counted(values_in(table, "seed").size(), "seed");
}

/// Returns a field, with its interval on a separate line.
std::string cell_of(const std::string& field) {
  std::string html = as_html(field);
  const std::size_t interval = html.find(" [");
  if (interval == std::string::npos) return html;
  return fmt::format("{}<br><small>{}</small>", html.substr(0, interval),
                     html.substr(interval + 1));
}

/// Returns a head that may be broken behind each underscore.
std::string head_of(const std::string& name) {
  std::string html;
  for (const char c : as_html(name)) html += c == '_' ? std::string("_<wbr>") : std::string(1, c);
  return html;
}

/// Returns a table with its heads on top.
std::string grid_of(const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"table\"><table>\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    html += "<tr>";
    for (const std::string& field : rows[k])
      html += k == 0 ? "<th>" + head_of(field) + "</th>" : "<td>" + cell_of(field) + "</td>";
    html += "</tr>\n";
  }
  return html + "</table></div>";
}

std::vector<std::string> columns_in(const avo_io::SweepTable& table) {
  std::vector<std::string> columns;
  for (const char* name : kPageColumns)
    if (std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end())
      columns.emplace_back(name);
  return columns;
}

/// Returns a section of tables, and one of figures: the arrivals of each block. Figures with too
/// many curves to tell apart are left out, and the page says so.
std::vector<std::string> comparison_sections(const Comparison& comparison) {
  const avo_io::SweepTable& table = comparison.tables.front().second;
  const std::vector<Case> cases = cases_of(comparison);
  const std::string by = usual_by(cases);
  std::string tables, figures;
  std::size_t drawn = 0, left_out = 0;
  for (const ComparisonBlock& block : blocks_of(cases, by, columns_in(table))) {
    const std::string heading = block.heading.empty() ? subtitle_of(table) : block.heading;
    tables += fmt::format("<h3>{}</h3>\n{}\n", as_html(heading), grid_of(block.rows));
    if (drawn == kMostFigures || block.cases.size() > kMostCurves) {
      ++left_out;
      continue;
    }
    ++drawn;
    const std::string svg = draw_arrivals(block.cases, {by}, "arrivals", "arrivals.svg");
    figures += fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", as_html(heading),
                           image_of(svg, "arrived over time: " + heading));
  }
  if (left_out > 0)
    figures += fmt::format("<p>{} left out: avo compare draws {} of at most {} curves.</p>",
                           counted(left_out, "figure"), left_out == 1 ? "it" : "them", kMostCurves);
  return {page_section("Means over the runs, with 95 % intervals", tables),
          page_figures("Arrivals over time", figures)};
}

/// A run of the sweep, simulated again.
struct ShownRun {
  avo_io::SweepRunScene scene;
  avo_io::RecordedRun run;
  std::uint64_t state_hash = 0;
};

void simulate_in_space(const avo_io::SweepSpec& spec, const avo::space::Scenario& scenario,
                       ShownRun& shown) {
  avo::figures::SpaceRecorder recorder(
      most_frames(2 * static_cast<std::int64_t>(scenario.robots.size())));
  Progress progress(scenario.duration);
  shown.state_hash = simulate_again(spec, scenario, [&](const avo::space::Simulation& simulation) {
    recorder.observe(simulation);
    progress.show(simulation.time());
  });
  shown.run = run_in_plane(scenario, recorder.frames());
}

ShownRun simulated(const avo_io::SweepSpec& spec, std::int64_t number) {
  ShownRun shown;
  shown.scene = scene_of_run(spec, number);
  if (const auto* in_space = std::get_if<avo::space::Scenario>(&shown.scene.scenario)) {
    simulate_in_space(spec, *in_space, shown);
    return shown;
  }
  const auto& scenario = std::get<avo::Scenario>(shown.scene.scenario);
  avo::figures::TrajectoryRecorder recorder(
      most_frames(static_cast<std::int64_t>(scenario.robots.size())));
  Progress progress(scenario.duration);
  shown.state_hash = simulate_again(spec, scenario, [&](const avo::Simulation& simulation) {
    recorder.observe(simulation);
    progress.show(simulation.time());
  });
  shown.run.scenario = scenario;
  for (const avo::figures::TrajectoryFrame& frame : recorder.frames())
    shown.run.frames.push_back(
        {frame.time, frame.position, frame.heading, frame.there, frame.mover_position});
  return shown;
}

std::int64_t number_of(const std::vector<std::string>& row) {
  return static_cast<std::int64_t>(avo_io::number_in(row[1]).value_or(-1.0));
}

/// Returns the row of that run. Throws UsageError if the table has none.
const std::vector<std::string>& row_of(const avo_io::SweepTable& table, const std::string& path,
                                       std::int64_t run) {
  for (const std::vector<std::string>& row : table.rows)
    if (number_of(row) == run) return row;
  throw UsageError(fmt::format("--run: found {}, must be one of the runs in {}", run, path));
}

std::string field_of(const avo_io::SweepTable& table, const std::vector<std::string>& row,
                     const std::string& column) {
  const auto at = std::find(table.columns.begin(), table.columns.end(), column);
  return at == table.columns.end() ? "" : row[static_cast<std::size_t>(at - table.columns.begin())];
}

/// Returns " --shard I/N" if the table has part I of N of the runs, by their numbers.
std::string shard_option(const avo_io::SweepSpec& spec, const avo_io::SweepTable& table) {
  if (std::ssize(table.rows) == run_count(spec)) return "";
  const std::int64_t first = number_of(table.rows.front());
  const std::int64_t parts =
      table.rows.size() > 1 ? number_of(table.rows[1]) - first : run_count(spec);
  return fmt::format(" --shard {}/{}", first + 1, parts);
}

/// Returns the run in the lab, which simulates it again; without the lab, it returns a drawing.
std::string motion_of(const std::string& heading, const ShownRun& shown) {
  const bool in_space = std::holds_alternative<avo::space::Scenario>(shown.scene.scenario);
  if (lab_page().empty())
    return page_replay(in_space ? heading + ", from above, and from the side" : heading, shown.run,
                       in_space ? 2 : 1);
  avo_io::SceneSource source;
  if (in_space)
    (void)avo_io::load_space_scenario(shown.scene.name, shown.scene.overrides, &source);
  else
    (void)avo_io::load_scenario(shown.scene.name, shown.scene.overrides, &source);
  return page_lab(heading, scene_input(source, true));
}

std::vector<std::string> run_sections(const ReportArguments& arguments,
                                      const avo_io::SweepSpec& spec,
                                      const avo_io::SweepTable& table) {
  if (fingerprint(spec) != table.rows.front().front())
    throw avo_io::RecordingError(
        fmt::format("{}: found a table of another sweep, or of other scenes or another version of "
                    "avo, must be of {}",
                    arguments.input, arguments.spec));
  const std::int64_t number = arguments.run.value_or(number_of(table.rows.front()));
  const std::vector<std::string>& row = row_of(table, arguments.input, number);
  const ShownRun shown = simulated(spec, number);
  const std::string hash = fmt::format("{:#018x}", shown.state_hash);
  if (hash != field_of(table, row, "state_hash"))
    throw avo_io::RecordingError(
        fmt::format("{}: run {}: state_hash: found {}, must be {}, that of the run simulated again",
                    arguments.input, number, field_of(table, row, "state_hash"), hash));
  std::vector<std::pair<std::string, std::string>> results;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (!row[c].empty()) results.emplace_back(table.columns[c], row[c]);
  const std::string name = run_name(spec, number);
  std::string command = "avo run " + shell_word(shown.scene.name);
  command += set_options(shown.scene.overrides);
  if (spec.until_arrived) command += " --until-arrived";
  return {motion_of(fmt::format("Run {}: {}", number, name), shown),
          page_text("The command of this run", command), page_text("Its scene", shown.scene.yaml),
          page_section("Its row in the table", "<details><summary>all columns</summary>" +
                                                   table_of(results) + "</details>")};
}

/// Reads the table. A recording as CSV ends here too: it contains no scene, and cannot be reported.
avo_io::SweepTable table_in(const std::string& path) {
  try {
    return avo_io::read_sweep(path);
  } catch (const avo_io::RecordingError& error) {
    const std::string message = error.what();
    if (message.find("found no table") == std::string::npos) throw;
    throw avo_io::RecordingError(message + "; a recording must be HDF5");
  }
}

}  // namespace

bool is_sweep_table(const std::string& path) {
  return path.ends_with(".csv") || avo_io::is_sweep_hdf5(path);
}

std::string sweep_page(const ReportArguments& arguments) {
  if (arguments.run && arguments.spec.empty())
    throw UsageError("--run: found without --spec, must be with it");
  Comparison comparison;
  comparison.tables.emplace_back(arguments.input, table_in(arguments.input));
  const avo_io::SweepTable& table = comparison.tables.front().second;
  if (table.rows.empty())
    throw avo_io::RecordingError(arguments.input + ": found no runs, must have at least one");
  std::vector<std::string> sections = comparison_sections(comparison);
  std::vector<std::pair<std::string, std::string>> provenance{
      {"avo", avo::kVersion}, {"table", arguments.input}, {"sweep", table.rows.front().front()}};
  if (!arguments.spec.empty()) {
    const avo_io::SweepSpec spec =
        avo_io::load_sweep(arguments.spec, own_methods_of(arguments.own_methods));
    const std::vector<std::string> shown = run_sections(arguments, spec, table);
    sections.insert(sections.end(), shown.begin(), shown.end());
    sections.push_back(
        page_text("Command", fmt::format("avo sweep {}{} --out {}", shell_word(arguments.spec),
                                         shard_option(spec, table), shell_word(arguments.input))));
    sections.push_back(page_text("Sweep", spec.text));
  } else {
    sections.push_back(
        "<p>With --spec the page has the sweep's file, its command, and one run in "
        "motion.</p>\n");
  }
  sections.push_back(page_section("Made by", table_of(provenance)));
  return page_of(avo_io::printable(arguments.input), subtitle_of(table), sections);
}

}  // namespace avo_cli
