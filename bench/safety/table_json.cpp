// SPDX-License-Identifier: Apache-2.0
// Makes a line of JSON from the outcomes of a row's scenes: keys in a fixed order, null for missing
// values.
#include <charconv>
#include <cmath>
#include <cstdint>

#include "options.h"
#include "table.h"

namespace avo::safety {
namespace {

// One object, member by member. No name or string here needs escapes.
class JsonObject {
 public:
  JsonObject& add(const char* name, double value) {
    if (!std::isfinite(value)) return add_raw(name, "null");
    char buffer[32];  // the shortest form of a double has at most 24 characters
    return add_raw(name, {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr});
  }
  JsonObject& add(const char* name, std::int64_t value) {
    return add_raw(name, std::to_string(value));
  }
  JsonObject& add(const char* name, const std::string& value) {
    return add_raw(name, "\"" + value + "\"");
  }
  JsonObject& add_raw(const char* name, const std::string& json) {
    members_ += (members_.empty() ? "\"" : ", \"") + std::string(name) + "\": " + json;
    return *this;
  }
  [[nodiscard]] std::string text() const { return "{" + members_ + "}"; }

 private:
  std::string members_;
};

template <class Range, class Text>
std::string json_array(const Range& range, Text text) {
  std::string json;
  for (const auto& value : range) json += (json.empty() ? "" : ", ") + text(value);
  return "[" + json + "]";
}

std::string planner_json(const PlannerOptions& options) {
  return JsonObject()
      .add("method", std::string(to_string(options.method)))
      .add("certificate", std::string(to_string(options.certificate)))
      .add("motion", std::string(to_string(options.motion)))
      .add("control_time", options.control_time)
      .add("time_horizon", options.time_horizon)
      .text();
}

std::string decisions_json(const RowResult& row) {
  JsonObject object;
  for (std::size_t k = 0; k < kMostStatuses; ++k) {
    if (row.decisions[k] > 0) object.add(to_string(static_cast<PlanStatus>(k)), row.decisions[k]);
  }
  return object.text();
}

std::string scene_json(const Outcome& outcome) {
  std::vector<std::int64_t> missing;
  for (std::size_t i = 0; i < outcome.arrival.size(); ++i) {
    if (!std::isfinite(outcome.arrival[i])) missing.push_back(static_cast<std::int64_t>(i));
  }
  JsonObject object;
  object.add("seed", static_cast<std::int64_t>(outcome.seed))
      .add("overlapping_pairs", outcome.verdict.overlapping_pairs)
      .add("least_clearance", outcome.verdict.least_clearance.value_or(kNever))
      .add("static_contacts", outcome.verdict.static_contacts)
      .add("least_static_clearance", outcome.verdict.least_static_clearance.value_or(kNever));
  if (outcome.unit > 0.0) {
    object.add("unit", outcome.unit)
        .add("last_arrival", last_arrival(outcome))
        .add_raw("not_arrived",
                 json_array(missing, [](std::int64_t i) { return std::to_string(i); }));
  }
  if (outcome.rest) object.add("rest", *outcome.rest);
  return object.text();
}

}  // namespace

std::string json_line(const RowResult& row, const std::vector<Outcome>& outcomes) {
  JsonObject object;
  object.add("row", row.name)
      .add_raw("planner", planner_json(outcomes.front().planner))
      .add("scenes", row.scenes)
      .add("robots", row.robots)
      .add("robot_steps", row.robot_steps)
      .add("overlapping_pairs", row.overlapping_pairs)
      .add("moving_contacts", row.moving_contacts)
      .add("resting_contacts", row.resting_contacts)
      .add("static_contacts", row.static_contacts)
      .add("evadable_hits", row.evadable_hits)
      .add("acceleration_violations", row.acceleration_violations)
      .add("speed_violations", row.speed_violations)
      .add("jumps", row.jumps)
      .add("kinematic_violations", row.kinematic_violations)
      .add("changes", row.changes)
      .add("unsafe_scenes", row.unsafe_scenes)
      .add("unsafe_bound_95",
           row.unsafe_scenes == 0 ? 3.0 / static_cast<double>(row.scenes) : kNever)
      .add("least_clearance", row.least_clearance.value_or(kNever))
      .add("least_static_clearance", row.least_static_clearance.value_or(kNever))
      .add("interpolation_error", row.interpolation_error);
  if (row.has_goals) {
    object.add("arrived", row.arrived)
        .add("at_goal_at_end", row.at_goal_at_end)
        .add("full_scenes", row.full_scenes)
        .add("fewest_arrived", row.fewest_arrived)
        .add("median_last_arrival", row.median_last)
        .add("mean_arrival", row.mean)
        .add("last_arrival", row.last)
        .add("arrival_99", row.late)
        .add("last_ratio", row.last_ratio)
        .add("ratio_99", row.late_ratio)
        .add("limit_ratio", row.limit)
        .add("late_scenes", row.late_scenes)
        .add("median_last_ratio", row.median_ratio)
        .add("last_ratio_95", row.high_ratio);
    if (row.median_rest) {
      object.add("resting_scenes", row.resting_scenes)
          .add("median_rest", *row.median_rest)
          .add("last_rest", *row.last_rest)
          .add("longest_to_rest", *row.longest_to_rest);
    }
  }
  if (row.mean_flow) {
    object.add("flow", *row.mean_flow).add("least_flow", *row.least_flow);
    object.add("late_flow", *row.mean_late_flow).add("least_late_flow", *row.least_late_flow);
  }
  object.add_raw("decisions", decisions_json(row))
      .add("microseconds", row.microseconds)
      .add("worst_second_microseconds", row.worst_microseconds)
      .add("density", row.density > 0.0 ? row.density : kNever)
      .add_raw("outcomes", json_array(outcomes, scene_json));
  return object.text() + "\n";
}

}  // namespace avo::safety
