// SPDX-License-Identifier: Apache-2.0
// The number of arrived robots over time, from the tables of sweeps: the curve of avo compare
// --arrival.
#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <optional>

#include "reports/comparison.h"
#include "reports/curves.h"

namespace avo_cli {
namespace {

using avo::Vec2;
using ArrivalCurve = std::vector<Vec2>;  // (s, %); both never decrease

/// Returns the columns that a run's curve goes through, in order, with their shares in %.
std::vector<std::pair<std::size_t, double>> quantile_columns(const avo_io::SweepTable& table) {
  std::vector<std::pair<std::size_t, double>> found;
  const auto add = [&](const std::string& name, double share) {
    const auto at = std::find(table.columns.begin(), table.columns.end(), name);
    if (at != table.columns.end())
      found.emplace_back(static_cast<std::size_t>(at - table.columns.begin()), share);
  };
  add("first_arrival", 0.0);
  for (int percent = 10; percent <= 100; percent += 10)
    add(fmt::format("arrival_{}", percent), percent);
  add("last_arrival", 100.0);
  return found;
}

/// Returns the share at a time, just before or just behind it: these differ where the curve jumps.
double share_at(const ArrivalCurve& curve, double time, bool behind) {
  const auto next = behind ? std::upper_bound(curve.begin(), curve.end(), time,
                                              [](double t, Vec2 point) { return t < point.x; })
                           : std::lower_bound(curve.begin(), curve.end(), time,
                                              [](Vec2 point, double t) { return point.x < t; });
  if (next == curve.begin()) return 0.0;
  const Vec2 before = *std::prev(next);
  if (next == curve.end() || before.x == time) return before.y;
  return before.y + (next->y - before.y) * (time - before.x) / (next->x - before.x);
}

}  // namespace

std::vector<Vec2> arrivals_of(const Case& entry) {
  const auto columns = quantile_columns(*entry.table);
  std::vector<ArrivalCurve> runs;
  std::vector<Vec2> times;  // only .x is used
  for (const auto* run : entry.runs) {
    ArrivalCurve& curve = runs.emplace_back();
    for (const auto& [column, share] : columns)
      if (const std::optional<double> time = avo_io::number_in((*run)[column]))
        curve.push_back({*time, share});
    times.insert(times.end(), curve.begin(), curve.end());
  }
  std::sort(times.begin(), times.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  times.erase(std::unique(times.begin(), times.end(), [](Vec2 a, Vec2 b) { return a.x == b.x; }),
              times.end());
  const auto mean_at = [&](double time, bool behind) {
    double sum = 0.0;
    for (const ArrivalCurve& run : runs) sum += share_at(run, time, behind);
    return sum / static_cast<double>(runs.size());
  };
  std::vector<Vec2> points{{0.0, 0.0}};
  for (const Vec2 at : thinned(times))
    for (const bool behind : {false, true})
      if (const Vec2 point{at.x, mean_at(at.x, behind)}; point != points.back())
        points.push_back(point);
  return points;
}

}  // namespace avo_cli
