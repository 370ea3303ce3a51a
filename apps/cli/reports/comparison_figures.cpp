// SPDX-License-Identifier: Apache-2.0
// The figures of avo compare.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>

#include "avo_io/printable.h"
#include "exit_codes.h"
#include "figures/chart.h"
#include "figures/trajectories.h"
#include "reports/comparison.h"
#include "reports/curves.h"

namespace avo_cli {
namespace {

using avo::Vec2;
using avo::figures::Series;

constexpr std::size_t kMostPanels = 6;

/// pt, drawn and left out in turn: they distinguish curves for readers without color vision. With
/// twelve curves, two with the same dashes have opposite colors.
constexpr std::array<std::array<double, 4>, 6> kDashes{
    {{}, {6, 3, 6, 3}, {1.5, 2, 1.5, 2}, {8, 2.5, 1.5, 2.5}, {13, 3, 13, 3}, {5, 2, 2, 2}}};

/// Assigns colors and dashes. Throws UsageError if there are too many curves, or none.
std::string draw(avo::figures::Chart chart, const std::string& role, const std::string& path) {
  const std::size_t count = chart.series.size();
  if (count > kMostCurves)
    throw UsageError(fmt::format("{}: found {} curves, must be at most {}: compare fewer runs",
                                 role, count, kMostCurves));
  for (std::size_t k = 0; k < count; ++k) {
    Series& series = chart.series[k];
    series.plain = true;
    series.color =
        avo::figures::hue_color(210.0 + 360.0 * static_cast<double>(k) /
                                            static_cast<double>(std::max<std::size_t>(count, 3)));
    series.pattern = kDashes[k % kDashes.size()];
  }
  return draw_chart(chart, path);
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

avo::figures::Chart arrivals_chart(const std::vector<Case>& cases,
                                   const std::vector<std::string>& keys) {
  avo::figures::Chart chart{"time (s)", "arrived (%)", {}, 100.0};
  for (const Case& entry : cases)
    chart.series.push_back({label_of(entry, keys), arrivals_of(entry), {}, false});
  return chart;
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
  std::vector<std::string> keys = varying_keys(cases);
  if (keys.empty()) keys = {"scene", "method"};
  avo::figures::Chart chart = arrivals_chart(cases, keys);
  for (const auto& [name, run] : comparison.recordings)
    chart.series.push_back({stem(name), arrivals_of(run), {}, false});
  extend(chart.series);
  return draw(std::move(chart), role, path);
}

std::string draw_arrivals(const std::vector<Case>& cases, const std::vector<std::string>& keys,
                          const std::string& role, const std::string& path) {
  avo::figures::Chart chart = arrivals_chart(cases, keys);
  extend(chart.series);
  return draw(std::move(chart), role, path);
}

std::string draw_clearances(const Comparison& comparison, const std::string& role,
                            const std::string& path) {
  require_recordings(comparison, role);
  avo::figures::Chart chart{"time (s)", "least clearance (m)", {}};
  for (const auto& [name, run] : comparison.recordings) {
    chart.series.push_back({stem(name), clearances_of(run), {}, false});
  }
  return draw(std::move(chart), role, path);
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
  avo::figures::Chart chart{"number of robots", "time of a step (ms)", {}};
  for (const auto& [label, points] : scaling_of(cases_of(comparison)))
    chart.series.push_back({label, points, {}});
  if (chart.series.empty())
    throw UsageError(role + ": found no table with times of steps, must be one of avo sweep");
  return draw(std::move(chart), role, path);
}

}  // namespace avo_cli
