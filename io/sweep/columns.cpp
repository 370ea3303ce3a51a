// SPDX-License-Identifier: Apache-2.0
// The columns of a sweep's table: one line here for each column.
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "core/ranges.h"
#include "io/sweep/runs.h"

namespace avo_io {
namespace {

using Value = std::optional<double>;

struct SweepColumn {
  const char* name;
  Value (*of)(const RunOutcome& run);
};

/// Returns s until `percent` of all robots that are not parked have arrived; none if fewer arrive.
template <int percent>
Value arrival_of(const RunOutcome& run) {
  const std::int64_t travelers = run.summary.robots - run.summary.parked;
  const std::int64_t number = (percent * travelers + 99) / 100;  // rounded up
  if (number < 1 || number > std::ssize(run.arrivals)) return std::nullopt;
  return run.arrivals[static_cast<std::size_t>(number - 1)];
}

/// Returns s until the first robot that is not parked arrives; none if none arrives.
Value first_arrival_of(const RunOutcome& run) {
  if (run.arrivals.empty()) return std::nullopt;
  return run.arrivals.front();
}

template <typename Number>
Value as_value(const Number& value) {
  if constexpr (requires { value.has_value(); }) {
    if (!value) return std::nullopt;
    return static_cast<double>(*value);
  } else {
    return static_cast<double>(value);
  }
}

template <auto member>
Value of_summary(const RunOutcome& run) {
  return as_value(run.summary.*member);
}

template <auto member>
Value of_metrics(const RunOutcome& run) {
  return as_value(run.summary.metrics.*member);
}

template <auto member>
Value of_decisions(const RunOutcome& run) {
  return static_cast<double>(run.summary.decisions.*member);
}

// Returns whether robots have collided. It counts a robot at rest that another robot runs into.
bool has_collided(const avo::RunSummary& run) {
  return run.collision_pairs > 0 || run.one_sided_collisions > 0 || run.mover_collisions > 0 ||
         run.static_collisions > 0;
}

using avo::Decisions;
using avo::RunMetrics;
using avo::RunSummary;

constexpr SweepColumn kResults[] = {
    {"robots", of_summary<&RunSummary::robots>},
    {"parked", of_summary<&RunSummary::parked>},
    {"steps", of_summary<&RunSummary::steps>},
    {"arrived", of_summary<&RunSummary::arrived>},
    {"all_arrived",
     [](const RunOutcome& run) -> Value {
       return run.summary.arrived == run.summary.robots ? 1.0 : 0.0;
     }},
    {"collided",
     [](const RunOutcome& run) -> Value { return has_collided(run.summary) ? 1.0 : 0.0; }},
    {"collision_pairs", of_summary<&RunSummary::collision_pairs>},
    {"one_sided_collisions", of_summary<&RunSummary::one_sided_collisions>},
    {"one_sided_collisions_in_motion", of_summary<&RunSummary::one_sided_collisions_in_motion>},
    {"mover_collisions", of_summary<&RunSummary::mover_collisions>},
    {"mover_collisions_in_motion", of_summary<&RunSummary::mover_collisions_in_motion>},
    {"mover_collisions_evadable", of_summary<&RunSummary::mover_collisions_evadable>},
    {"static_collisions", of_summary<&RunSummary::static_collisions>},
    {"first_collision_time", of_summary<&RunSummary::first_collision_time>},
    {"min_clearance", of_summary<&RunSummary::min_clearance>},
    {"min_static_clearance", of_summary<&RunSummary::min_static_clearance>},
    {"first_seen_too_late", of_summary<&RunSummary::first_seen_too_late>},
    {"max_acceleration", of_summary<&RunSummary::max_acceleration>},
    {"acceleration_excess", of_summary<&RunSummary::acceleration_excess>},
    {"max_speed", of_summary<&RunSummary::max_speed>},
    {"first_arrival", first_arrival_of},
    {"mean_arrival", of_summary<&RunSummary::mean_arrival>},
    {"last_arrival", of_summary<&RunSummary::last_arrival>},
    {"arrival_10", arrival_of<10>},
    {"arrival_20", arrival_of<20>},
    {"arrival_30", arrival_of<30>},
    {"arrival_40", arrival_of<40>},
    {"arrival_50", arrival_of<50>},
    {"arrival_60", arrival_of<60>},
    {"arrival_70", arrival_of<70>},
    {"arrival_80", arrival_of<80>},
    {"arrival_90", arrival_of<90>},
    {"arrival_100", arrival_of<100>},
    {"unreachable",
     [](const RunOutcome& run) -> Value {
       return static_cast<double>(run.summary.unreachable.size());
     }},
    {"infeasible_steps", of_summary<&RunSummary::infeasible_steps>},
    {"optimal", of_decisions<&Decisions::optimal>},
    {"least_unsafe", of_decisions<&Decisions::least_unsafe>},
    {"refused", of_decisions<&Decisions::refused>},
    {"detour", of_decisions<&Decisions::detour>},
    {"braking", of_decisions<&Decisions::braking>},
    {"overlapping", of_decisions<&Decisions::overlapping>},
    {"invalid_input", of_decisions<&Decisions::invalid_input>},
    {"trips", of_metrics<&RunMetrics::trips>},
    {"collision_robot_steps", of_metrics<&RunMetrics::collision_robot_steps>},
    {"overlap_depth", of_metrics<&RunMetrics::overlap_depth>},
    {"success", of_metrics<&RunMetrics::success>},
    {"collision", of_metrics<&RunMetrics::collision>},
    {"timeout", of_metrics<&RunMetrics::timeout>},
    {"extra_time_mean", of_metrics<&RunMetrics::extra_time_mean>},
    {"extra_time_p75", of_metrics<&RunMetrics::extra_time_p75>},
    {"extra_time_p90", of_metrics<&RunMetrics::extra_time_p90>},
    {"flowtime", of_metrics<&RunMetrics::flowtime>},
    {"path_ratio", of_metrics<&RunMetrics::path_ratio>},
    {"effort", of_metrics<&RunMetrics::effort>},
    {"acceleration_rms", of_metrics<&RunMetrics::acceleration_rms>},
    {"jerk", of_metrics<&RunMetrics::jerk>},
    {"reversals", of_metrics<&RunMetrics::reversals>},
    {"turned_back", of_metrics<&RunMetrics::turned_back>},
    {"efficacy", of_metrics<&RunMetrics::efficacy>},
    {"deadlock_time", of_metrics<&RunMetrics::deadlock_time>},
    {"danger", of_metrics<&RunMetrics::danger>},
    {"danger_separation", of_metrics<&RunMetrics::danger_separation>},
    {"order", of_metrics<&RunMetrics::order>},
    {"density_mean", of_metrics<&RunMetrics::density_mean>},
    {"density_max", of_metrics<&RunMetrics::density_max>},
};

/// The columns of a measuring line.
constexpr SweepColumn kFlows[] = {
    {"crossings",
     [](const RunOutcome& run) -> Value {
       const auto& times = run.summary.metrics.crossing_times;
       if (!times) return std::nullopt;
       return static_cast<double>(times->size());
     }},
    {"flow", of_metrics<&RunMetrics::flow>},
    {"specific_flow", of_metrics<&RunMetrics::specific_flow>},
};

constexpr SweepColumn kTimes[] = {
    {"step_ms_p50", of_metrics<&RunMetrics::step_ms_p50>},
    {"step_ms_p99", of_metrics<&RunMetrics::step_ms_p99>},
    {"step_milliseconds_median", of_summary<&RunSummary::step_milliseconds_median>},
    {"seconds", [](const RunOutcome& run) -> Value { return run.seconds; }},
};

/// Returns all quantities that describe the runs of a sweep, in the order of its table.
std::vector<SweepColumn> results_of(const SweepSpec& spec) {
  std::vector<SweepColumn> columns(std::begin(kResults), std::end(kResults));
  if (spec.line) columns.insert(columns.end(), std::begin(kFlows), std::end(kFlows));
  columns.insert(columns.end(), std::begin(kTimes), std::end(kTimes));
  return columns;
}

std::string field_of(const Value& value) {
  return value && std::isfinite(*value) ? avo::text(*value) : "";
}

// Space has method avo alone.
std::string name_of_method(const SweepScenario& scenario) {
  const auto* plane = std::get_if<avo::Scenario>(&scenario);
  return plane != nullptr ? std::string(method_name(*plane)) : avo::to_string(avo::Method::avo);
}

}  // namespace

bool is_sweep_timing(std::string_view column) {
  return column == "step_milliseconds_median" || column.starts_with("step_ms_") ||
         column == "seconds";
}

std::vector<std::string> sweep_columns(const SweepSpec& spec) {
  std::vector<std::string> columns{"sweep", "run", "scene", "method"};
  for (const SweepParameter& parameter : spec.parameters) columns.push_back(parameter.key);
  columns.emplace_back("seed");
  columns.emplace_back("state_hash");
  for (const SweepColumn& column : results_of(spec)) columns.emplace_back(column.name);
  return columns;
}

std::vector<std::string> sweep_row(const SweepSpec& spec, const std::string& sweep,
                                   const SweepRun& run, const SweepScenario& scenario,
                                   const RunOutcome& outcome) {
  std::vector<std::string> row{sweep, fmt::format("{}", run.number), run.scene,
                               name_of_method(scenario)};
  row.insert(row.end(), run.values.begin(), run.values.end());
  row.push_back(fmt::format("{}", std::visit([](const auto& own) { return own.seed; }, scenario)));
  row.push_back(fmt::format("{:#018x}", outcome.state_hash));
  for (const SweepColumn& column : results_of(spec)) row.push_back(field_of(column.of(outcome)));
  return row;
}

}  // namespace avo_io
