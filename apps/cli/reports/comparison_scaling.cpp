// SPDX-License-Identifier: Apache-2.0
// The cost of a step over the number of robots, as in the paper's Fig. 10: the curves of avo
// compare --scaling.
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "reports/comparison.h"

namespace avo_cli {
namespace {

using avo::Vec2;

/// The median step of a run with this number of robots.
struct StepTime {
  double robots = 0.0;
  double milliseconds = 0.0;
};

/// Returns the step times of the runs that have both values.
std::vector<StepTime> step_times_of(const Case& entry) {
  const std::vector<std::string>& columns = entry.table->columns;
  const auto robots = std::find(columns.begin(), columns.end(), "robots");
  const auto time = std::find(columns.begin(), columns.end(), "step_milliseconds_median");
  std::vector<StepTime> times;
  if (robots == columns.end() || time == columns.end()) return times;
  for (const auto* run : entry.runs) {
    const auto x = avo_io::number_in((*run)[static_cast<std::size_t>(robots - columns.begin())]);
    const auto y = avo_io::number_in((*run)[static_cast<std::size_t>(time - columns.begin())]);
    if (x && y) times.push_back({*x, *y});
  }
  return times;
}

/// Returns whether each value of the key belongs to one number of robots, and each to a different
/// one.
bool tells_number(const std::vector<Case>& cases, const std::string& key) {
  std::map<std::string, std::set<double>> numbers;
  for (const Case& entry : cases)
    for (const StepTime& time : step_times_of(entry))
      numbers[entry.value_of(key)].insert(time.robots);
  std::set<double> all;
  for (const auto& [value, found] : numbers)
    if (found.size() != 1 || !all.insert(*found.begin()).second) return false;
  return true;
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

}  // namespace

std::vector<std::pair<std::string, std::vector<Vec2>>> scaling_of(const std::vector<Case>& cases) {
  std::vector<std::string> keys = varying_keys(cases);
  std::erase_if(keys, [&](const std::string& key) {
    return key == "scene" || (key != "method" && key != "table" && tells_number(cases, key));
  });
  if (keys.empty()) keys = {"method"};
  std::vector<std::pair<std::string, std::vector<Vec2>>> curves;
  // by label, then by number of robots
  std::map<std::string, std::map<double, std::vector<double>>> times;
  for (const Case& entry : cases) {
    const std::string label = label_of(entry, keys);
    const std::vector<StepTime> found = step_times_of(entry);
    if (!found.empty() && !times.contains(label)) curves.push_back({label, {}});
    for (const StepTime& time : found) times[label][time.robots].push_back(time.milliseconds);
  }
  for (auto& [label, points] : curves)
    for (const auto& [robots, values] : times[label]) points.push_back({robots, median_of(values)});
  return curves;
}

}  // namespace avo_cli
