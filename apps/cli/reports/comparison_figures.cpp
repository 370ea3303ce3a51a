// SPDX-License-Identifier: Apache-2.0
// The figures of avo compare.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <set>

#include "avo_io/printable.h"
#include "exit_codes.h"
#include "figures/chart.h"
#include "figures/colors.h"
#include "figures/trajectories.h"
#include "reports/comparison.h"
#include "reports/curves.h"

namespace avo_cli {
namespace {

using avo::figures::Chart;
using avo::figures::Series;

constexpr std::size_t kMostPanels = 6;  // of trajectories
constexpr std::size_t kMostCharts = 12;

/// pt, drawn and left out in turn: they distinguish curves for readers without color vision. With
/// twelve curves, two with the same dashes have opposite colors.
constexpr std::array<std::array<double, 4>, 6> kDashes{
    {{}, {6, 3, 6, 3}, {1.5, 2, 1.5, 2}, {8, 2.5, 1.5, 2.5}, {13, 3, 13, 3}, {5, 2, 2, 2}}};

/// Returns the different labels of all curves, in their order.
std::vector<std::string> labels_of(const std::vector<Chart>& charts) {
  std::vector<std::string> labels;
  for (const Chart& chart : charts)
    for (const Series& series : chart.series)
      if (std::find(labels.begin(), labels.end(), series.label) == labels.end())
        labels.push_back(series.label);
  return labels;
}

/// Draws the charts. Curves of one label have one color and one kind of dashes in all of them.
/// Throws UsageError if there are too many charts or labels.
std::string draw(std::vector<Chart> charts, const std::string& role, const std::string& path) {
  const std::vector<std::string> labels = labels_of(charts);
  const std::size_t count = labels.size();
  if (count > kMostCurves)
    throw UsageError(fmt::format("{}: found {} curves, must be at most {}: compare fewer runs",
                                 role, count, kMostCurves));
  if (charts.size() > kMostCharts)
    throw UsageError(fmt::format("{}: found {} charts, must be at most {}: compare fewer scenes",
                                 role, charts.size(), kMostCharts));
  for (Chart& chart : charts)
    for (Series& series : chart.series) {
      const auto k = static_cast<std::size_t>(
          std::find(labels.begin(), labels.end(), series.label) - labels.begin());
      series.plain = true;
      series.color = avo::figures::color_of(k, count);
      series.pattern = kDashes[k % kDashes.size()];
    }
  return draw_charts(charts, path);
}

std::string stem(const std::string& recording) {
  return avo_io::printable(std::filesystem::path(recording).stem().string());
}

/// Extends curves that end before others by their last value: no robot arrives any more.
void extend(std::vector<Series>& curves) {
  double last = 0.0;
  for (const Series& curve : curves) last = std::max(last, curve.points.back().x);
  for (Series& curve : curves)
    if (curve.points.back().x < last) curve.points.push_back({last, curve.points.back().y});
}

/// The charts of a figure, one for each title.
struct Panels {
  Chart like;  // the axes of each
  std::vector<Chart> charts = {};

  void add(const std::string& title, Series series) {
    auto at = std::find_if(charts.begin(), charts.end(),
                           [&](const Chart& chart) { return chart.title == title; });
    if (at == charts.end()) {
      at = charts.insert(at, like);
      at->title = title;
    }
    at->series.push_back(std::move(series));
  }
};

/// Returns the names of the scenes of all cases and recordings.
std::set<std::string> scenes_of(const Comparison& comparison, const std::vector<Case>& cases) {
  std::set<std::string> scenes;
  for (const Case& entry : cases) scenes.insert(entry.value_of("scene"));
  for (const auto& [name, run] : comparison.recordings) scenes.insert(run.scenario.name);
  return scenes;
}

/// Returns the title of the chart that shows a recording; empty if all runs are of one scene.
std::string title_of(const avo_io::RecordedRun& run, const std::set<std::string>& scenes) {
  return scenes.size() < 2 ? "" : avo_io::printable("scene " + run.scenario.name);
}

void require_recordings(const Comparison& comparison, const std::string& role) {
  if (comparison.recordings.empty())
    throw UsageError(role +
                     ": found no recording, must be one or more, of avo run --record FILE.h5");
}

}  // namespace

std::string draw_arrivals(const Comparison& comparison, const std::string& role,
                          const std::string& path) {
  const std::vector<Case> cases = cases_of(comparison);
  const std::set<std::string> scenes = scenes_of(comparison, cases);
  const std::string by = comparison.by.empty() ? usual_by(cases) : comparison.by;
  std::vector<std::string> others = varying_keys(cases);  // what the titles say
  std::erase(others, by);
  if (by != "scene" && scenes.size() > 1 &&
      std::find(others.begin(), others.end(), "scene") == others.end())
    others.emplace_back("scene");
  Panels panels{{"time (s)", "arrived (%)", {}, 100.0}};
  for (const Case& entry : cases)
    panels.add(label_of(entry, others, true),
               {label_of(entry, {by}, true), arrivals_of(entry), {}, false});
  for (const auto& [name, run] : comparison.recordings)
    panels.add(by == "scene" ? "" : title_of(run, scenes),
               {stem(name), arrivals_of(run), {}, false});
  for (Chart& chart : panels.charts) extend(chart.series);
  return draw(std::move(panels.charts), role, path);
}

std::string draw_arrivals(const std::vector<Case>& cases, const std::vector<std::string>& keys,
                          const std::string& role, const std::string& path) {
  Panels panels{{"time (s)", "arrived (%)", {}, 100.0}};
  for (const Case& entry : cases)
    panels.add("", {label_of(entry, keys, true), arrivals_of(entry), {}, false});
  for (Chart& chart : panels.charts) extend(chart.series);
  return draw(std::move(panels.charts), role, path);
}

std::string draw_clearances(const Comparison& comparison, const std::string& role,
                            const std::string& path) {
  require_recordings(comparison, role);
  const std::set<std::string> scenes = scenes_of(comparison, {});
  Panels panels{{"time (s)", "least clearance (m)", {}}};
  for (const auto& [name, run] : comparison.recordings)
    panels.add(title_of(run, scenes), {stem(name), clearances_of(run), {}, false});
  return draw(std::move(panels.charts), role, path);
}

std::string draw_traces(const Comparison& comparison, const std::string& role,
                        const std::string& path) {
  require_recordings(comparison, role);
  if (comparison.recordings.size() > kMostPanels)
    throw UsageError(fmt::format("{}: found {} recordings, must be at most {}", role,
                                 comparison.recordings.size(), kMostPanels));
  std::vector<avo::figures::TracedRun> runs;
  for (const auto& [name, run] : comparison.recordings) {
    avo::figures::TracedRun& traced = runs.emplace_back();
    traced.title = stem(name);
    traced.scenario = run.scenario;
    traced.frames = frames_of(run);
  }
  return draw_side_by_side(runs, path);
}

std::string draw_scaling(const Comparison& comparison, const std::string& role,
                         const std::string& path) {
  Chart chart{"number of robots", "time of a step (ms)", {}};
  for (const auto& [label, points] : scaling_of(cases_of(comparison)))
    chart.series.push_back({label, points, {}});
  if (chart.series.empty())
    throw UsageError(role + ": found no table with times of steps, must be one of avo sweep");
  return draw({std::move(chart)}, role, path);
}

}  // namespace avo_cli
