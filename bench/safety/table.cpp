// SPDX-License-Identifier: Apache-2.0
// Makes a line of the table from the outcomes of a row's scenes.
#include "table.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numeric>

#include "density.h"

namespace avo::safety {
namespace {

__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...) {
  char buffer[512];
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(buffer, sizeof buffer, pattern, values);
  va_end(values);
  return buffer;
}

double percent(std::int64_t part, std::int64_t all) {
  return all > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

// Returns the smallest value that at least this part of the values does not exceed.
double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(values.size())));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

bool is_late(const Outcome& outcome) {
  if (outcome.unit == 0.0) return false;
  const double deadline = outcome.limit * outcome.unit * (1.0 + 1e-9);
  const auto in_time = std::count_if(outcome.arrival.begin(), outcome.arrival.end(),
                                     [&](double time) { return time <= deadline; });
  return static_cast<double>(in_time) < outcome.share * static_cast<double>(outcome.arrival.size());
}

void add_safety(const Outcome& outcome, RowResult& row) {
  const Verdict& verdict = outcome.verdict;
  row.overlapping_pairs += verdict.overlapping_pairs;
  row.moving_contacts += verdict.moving_contacts;
  row.resting_contacts += verdict.resting_contacts;
  row.static_contacts += verdict.static_contacts;
  row.evadable_hits += verdict.evadable_hits;
  row.deepest_contact = std::max(row.deepest_contact, verdict.deepest_contact);
  row.acceleration_violations += verdict.acceleration_violations;
  row.speed_violations += verdict.speed_violations;
  row.jumps += verdict.jumps;
  row.kinematic_violations += verdict.kinematic_violations;
  row.changes += verdict.changes;
  row.unsafe_scenes += verdict.safe() ? 0 : 1;
  row.certified =
      row.certified || (outcome.promised && outcome.planner.certificate != Certificate::none);
  row.least_clearance = least_of(row.least_clearance, verdict.least_clearance);
  row.least_static_clearance = least_of(row.least_static_clearance, verdict.least_static_clearance);
  row.interpolation_error = std::max(row.interpolation_error, verdict.interpolation_error);
}

// Returns the median; for an even number it is the mean of the two middle values.
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void compare_scenes(const std::vector<Outcome>& outcomes, RowResult& row) {
  row.fewest_arrived = row.robots;
  std::vector<double> lasts, last_ratios, rests, flows, late_flows;
  for (const Outcome& outcome : outcomes) {
    const auto never = std::count(outcome.arrival.begin(), outcome.arrival.end(), kNever);
    const std::int64_t arrived = static_cast<std::int64_t>(outcome.arrival.size()) - never;
    row.full_scenes += never == 0 ? 1 : 0;
    row.fewest_arrived = std::min(row.fewest_arrived, arrived);
    lasts.push_back(std::min(last_arrival(outcome), outcome.duration));
    if (outcome.unit > 0.0) last_ratios.push_back(last_arrival(outcome) / outcome.unit);
    if (outcome.flow) flows.push_back(*outcome.flow);
    if (outcome.late_flow) late_flows.push_back(*outcome.late_flow);
    if (!outcome.rest) continue;
    row.resting_scenes += std::isfinite(*outcome.rest) ? 1 : 0;
    rests.push_back(std::min(*outcome.rest, outcome.duration));
    const double after = rests.back() - lasts.back();
    row.longest_to_rest = std::max(row.longest_to_rest.value_or(after), after);
  }
  row.median_ratio = quantile(last_ratios, 0.5), row.high_ratio = quantile(last_ratios, 0.95);
  if (!flows.empty()) {
    row.mean_flow = mean(flows), row.least_flow = quantile(flows, 0.0);
    row.mean_late_flow = mean(late_flows), row.least_late_flow = quantile(late_flows, 0.0);
  }
  if (!rests.empty()) row.median_rest = median(rests), row.last_rest = quantile(rests, 1.0);
  row.median_last = median(std::move(lasts));
}

std::string time_text(double value, int width) {
  return std::isfinite(value) ? format("%*.1f", width, value) : format("%*s", width, "never");
}

std::string ratio_text(double value, int width) {
  return std::isfinite(value) ? format("%*.2f", width, value) : format("%*s", width, "-");
}

// Returns the bound by the rule of three: with confidence 95 % it bounds the rate of failures if
// none was seen.
std::string bound_text(const RowResult& row) {
  if (row.unsafe_scenes > 0) {
    return format("%lld unsafe", static_cast<long long>(row.unsafe_scenes));
  }
  if (row.scenes <= 3) return "0 unsafe";
  return format("< %.2g %%", 300.0 / static_cast<double>(row.scenes));
}

std::string decision_text(const RowResult& row) {
  std::string text;
  for (std::size_t k = 0; k < kMostStatuses; ++k) {
    if (row.decisions[k] == 0) continue;
    text += (text.empty() ? "" : ", ") + format("%s %.3g %%", to_string(static_cast<PlanStatus>(k)),
                                                percent(row.decisions[k], row.robot_steps));
  }
  return text;
}

}  // namespace

double last_arrival(const Outcome& outcome) {
  double last = 0.0;
  for (const double time : outcome.arrival) last = std::max(last, time);
  return last;
}

RowResult summarize(const std::string& name, const std::vector<Outcome>& outcomes) {
  RowResult row;
  row.name = name;
  std::vector<double> arrivals, ratios;
  double seconds = 0.0;
  for (const Outcome& outcome : outcomes) {
    ++row.scenes;
    row.robots += static_cast<std::int64_t>(outcome.arrival.size());
    row.robot_steps += outcome.robot_steps;
    add_safety(outcome, row);
    row.has_goals = outcome.unit > 0.0;
    row.limit = outcome.limit;
    row.at_goal_at_end += outcome.at_goal_at_end;
    row.late_scenes += is_late(outcome) ? 1 : 0;
    for (const double time : outcome.arrival) {
      if (std::isfinite(time)) ++row.arrived, row.mean += time;
      arrivals.push_back(time);
      ratios.push_back(time / outcome.unit);
      row.last = std::max(row.last, time);
      row.last_ratio = std::max(row.last_ratio, ratios.back());
    }
    for (std::size_t k = 0; k < kMostStatuses; ++k) row.decisions[k] += outcome.decisions[k];
    seconds += outcome.seconds;
    row.worst_microseconds = std::max(row.worst_microseconds, 1e6 * outcome.worst_second);
    row.density = std::max(row.density, outcome.density);
  }
  row.mean /= static_cast<double>(std::max<std::int64_t>(row.arrived, 1));
  compare_scenes(outcomes, row);
  row.late = quantile(std::move(arrivals), 0.99);
  row.late_ratio = quantile(std::move(ratios), 0.99);
  row.microseconds =
      1e6 * seconds / static_cast<double>(std::max<std::int64_t>(row.robot_steps, 1));
  return row;
}

std::string table_header() {
  return format("%-18s %6s %7s %9s %6s %6s %10s %8s %7s %7s %6s %6s %6s %6s %5s %6s %6s\n", "row",
                "scenes", "robots", "steps", "pairs", "a or v", "clear mm", "unsafe", "arrive%",
                "at end%", "last s", "99% s", "ratio", "99%", "late", "us", "worst");
}

std::string table_lines(const RowResult& row) {
  const std::int64_t limits = row.acceleration_violations + row.speed_violations + row.jumps +
                              row.kinematic_violations + row.changes;
  std::string line =
      format("%-18s %6lld %7lld %9lld %6lld %6lld %10s %8s", row.name.c_str(),
             static_cast<long long>(row.scenes), static_cast<long long>(row.robots),
             static_cast<long long>(row.robot_steps), static_cast<long long>(row.overlapping_pairs),
             static_cast<long long>(limits),
             row.least_clearance ? format("%.4g", 1e3 * *row.least_clearance).c_str() : "-",
             bound_text(row).c_str());
  if (row.has_goals) {
    line += format(" %7.2f %7.2f", percent(row.arrived, row.robots),
                   percent(row.at_goal_at_end, row.robots));
    line += " " + time_text(row.last, 6) + " " + time_text(row.late, 6);
    line += " " + ratio_text(row.last_ratio, 6) + " " + ratio_text(row.late_ratio, 6);
    line += format(" %5lld", static_cast<long long>(row.late_scenes));
  } else {
    line += format(" %7s %7s %6s %6s %6s %6s %5s", "-", "-", "-", "-", "-", "-", "-");
  }
  line += format(" %6.2f %6.2f\n", row.microseconds, row.worst_microseconds);
  if (row.has_goals && row.scenes > 1) {
    line += format(
        "  scenes: all arrive in %lld of %lld, the fewest in one are %lld; median of the last "
        "arrivals %.1f s (in units %s, 95 %% %s), mean of all %.2f s\n",
        static_cast<long long>(row.full_scenes), static_cast<long long>(row.scenes),
        static_cast<long long>(row.fewest_arrived), row.median_last,
        ratio_text(row.median_ratio, 0).c_str(), ratio_text(row.high_ratio, 0).c_str(), row.mean);
  }
  if (row.median_rest) {
    line += format(
        "  rest: nobody moves any more in %lld of %lld scenes, since %.1f s in the median, "
        "%.1f s at last, at most %.1f s after the last arrival\n",
        static_cast<long long>(row.resting_scenes), static_cast<long long>(row.scenes),
        *row.median_rest, *row.last_rest, *row.longest_to_rest);
  }
  if (row.mean_flow) {
    line += format(
        "  flow: %.3f of the preferred speed in the mean of the scenes, %.3f in one; from 60 s on "
        "%.3f and %.3f\n",
        *row.mean_flow, *row.least_flow, *row.mean_late_flow, *row.least_late_flow);
  }
  if (row.least_static_clearance) {
    line += format("  walls: touched by %lld robots, least clearance %.4g mm",
                   static_cast<long long>(row.static_contacts), 1e3 * *row.least_static_clearance);
    if (row.interpolation_error > 0.0) {
      line += format("; the paths judged are within %.2g mm of the true ones",
                     1e3 * row.interpolation_error);
    }
    line += "\n";
  }
  line += "  decisions: " + decision_text(row) + "\n";
  if (row.density > 0.0) {
    line +=
        format("  densest: %.1f %% of a disc about the centroid, %.1f %% of the densest packing\n",
               100.0 * row.density, 100.0 * row.density / kDensestPacking);
  }
  if (row.moving_contacts + row.resting_contacts > 0) {
    line +=
        format("  obstacles: touched by %lld robots in motion, by up to %.4g mm, %lld at rest\n",
               static_cast<long long>(row.moving_contacts), 1e3 * row.deepest_contact,
               static_cast<long long>(row.resting_contacts));
  }
  if (row.evadable_hits > 0) {
    line += format("  alone: %lld robots were hit that could have kept clear\n",
                   static_cast<long long>(row.evadable_hits));
  }
  return line;
}

std::string failure_lines(const RowResult& row, const std::vector<Outcome>& outcomes,
                          const std::string& settings) {
  constexpr int kNamed = 10;
  std::string lines;
  for (const Outcome& outcome : outcomes) {
    if (outcome.verdict.safe() && !is_late(outcome)) continue;
    lines += format("  seed %llu:", static_cast<unsigned long long>(outcome.seed));
    if (!outcome.verdict.safe()) lines += " " + outcome.verdict.violations + ";";
    int missing = 0;
    std::string names;
    for (std::size_t i = 0; i < outcome.arrival.size() && outcome.unit > 0.0; ++i) {
      if (std::isfinite(outcome.arrival[i])) continue;
      if (++missing <= kNamed) names += format(" %zu", i);
    }
    if (missing > 0) {
      lines += format(" %d not arrived:", missing) + names + (missing > kNamed ? " ..." : "") + ";";
    } else if (is_late(outcome)) {
      lines += " late;";
    }
    lines += " --row " + row.name + " --scenes 1 --first-seed " + std::to_string(outcome.seed) +
             settings + "\n";
  }
  return lines;
}

}  // namespace avo::safety
