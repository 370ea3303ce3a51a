// SPDX-License-Identifier: Apache-2.0
// The results of avo bench, as text and as JSON.
#include "reports/bench_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <numeric>

#include "avo/simd.h"
#include "avo_io/printable.h"

namespace avo_cli {
namespace {

double per(double sum, std::int64_t count) {
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// Pairs, decisions and nanoseconds of one robot in one step.
struct PerRobotStep {
  double pairs, infeasible;
  std::vector<avo::StageTime> stages;
};

PerRobotStep per_robot_step(const avo::StepProfile& profile) {
  const std::int64_t count = profile.robot_steps;
  PerRobotStep result{per(static_cast<double>(profile.pairs), count),
                      per(static_cast<double>(profile.infeasible), count), profile.stages};
  for (avo::StageTime& stage : result.stages) stage.nanoseconds = per(stage.nanoseconds, count);
  return result;
}

double nanoseconds_per_robot(double milliseconds, const BenchScene& scene) {
  return 1e6 * milliseconds / static_cast<double>(scene.robots);
}

std::size_t steps_in_a_second(const BenchScene& scene) {
  return static_cast<std::size_t>(std::clamp(std::round(1.0 / scene.time_step), 1.0, 1e6));
}

std::string joined(const std::vector<avo::StageTime>& stages) {
  std::string text;
  for (const avo::StageTime& stage : stages)
    text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", stage.name, stage.nanoseconds);
  return text;
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double densest(const std::vector<double>& milliseconds, std::size_t in_a_row) {
  const std::size_t width = std::clamp(in_a_row, std::size_t{1}, milliseconds.size());
  double largest = 0.0;
  for (std::size_t i = 0; i + width <= milliseconds.size(); ++i) {
    const auto first = milliseconds.begin() + static_cast<std::ptrdiff_t>(i);
    largest = std::max(largest, median({first, first + static_cast<std::ptrdiff_t>(width)}));
  }
  return largest;
}

std::string to_json(const BenchScene& scene, const BenchResults& results) {
  const PerRobotStep one = per_robot_step(results.profile);
  const double step = median(results.milliseconds);
  nlohmann::ordered_json json{
      {"scene", scene.name},
      {"robots", scene.robots},
      {"threads", results.threads},
      {"simd", avo::simd_target()},
      {"precision", "double"},
      {"method", scene.method},
      {"certificate", scene.certificate},
      {"step_milliseconds_median", step},
      {"step_milliseconds_mean", mean(results.milliseconds)},
      {"step_milliseconds_densest_second", densest(results.milliseconds, steps_in_a_second(scene))},
      {"nanoseconds_per_robot_step", nanoseconds_per_robot(step, scene)},
      {"pairs_per_robot", one.pairs},
      {"infeasible_share", one.infeasible},
      {"stages", nlohmann::ordered_json::object()}};
  if (one.stages.empty()) json["pairs_per_robot"] = nullptr;
  for (const avo::StageTime& stage : one.stages) json["stages"][stage.name] = stage.nanoseconds;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string readable(const BenchScene& scene, const BenchResults& results) {
  const PerRobotStep one = per_robot_step(results.profile);
  const double step = median(results.milliseconds);
  const double least = *std::min_element(results.milliseconds.begin(), results.milliseconds.end());
  std::string text = fmt::format(
      "{}: {} robots, {} thread{}, simd {}, precision double, method {}, certificate {}\n",
      avo_io::printable(scene.name), scene.robots, results.threads, results.threads == 1 ? "" : "s",
      avo::simd_target(), scene.method, scene.certificate);
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<18} {}\n", name, value);
  };
  line("time of a step", fmt::format("{:.4g} ms (median of {} steps, each the median of {} runs)",
                                     step, results.milliseconds.size(), results.runs));
  line("mean of a step", fmt::format("{:.4g} ms", mean(results.milliseconds)));
  line("quickest step", fmt::format("{:.4g} ms", least));
  line("densest second",
       fmt::format("{:.4g} ms (median)", densest(results.milliseconds, steps_in_a_second(scene))));
  line("a robot's share", fmt::format("{:.4g} ns", nanoseconds_per_robot(step, scene)));
  if (!one.stages.empty()) {
    line("stages", joined(one.stages) + " ns of all threads, a robot-step on average");
    line("pairs", fmt::format("{:.3g} a robot", one.pairs));
  }
  line("no safe choice", fmt::format("{:.3g} % of the decisions", 100.0 * one.infeasible));
  if (results.bytes > 0)
    line("memory", fmt::format("{:.4g} bytes a robot", static_cast<double>(results.bytes) /
                                                           static_cast<double>(scene.robots)));
  return text;
}

}  // namespace avo_cli
