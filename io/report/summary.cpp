// SPDX-License-Identifier: Apache-2.0
// The results of a run as one JSON object.
#include <fmt/format.h>
#include <optional>

#include "avo/version.h"
#include "avo_io/recording.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

Json to_json(const avo::Decisions& decisions) {
  return {{"optimal", decisions.optimal},
          {"least_unsafe", decisions.least_unsafe},
          {"refused", decisions.refused},
          {"detour", decisions.detour},
          {"braking", decisions.braking},
          {"overlapping", decisions.overlapping},
          {"invalid_input", decisions.invalid_input}};
}

Json to_json(const avo::NotArrived& robot) {
  Json held_by = Json::array();
  for (const std::int64_t entry : robot.held_by) held_by.push_back(name_of(entry));
  Json json{{"robot", robot.robot},
            {"distance", robot.distance},
            {"speed", robot.speed},
            {"status", avo::to_string(robot.status)},
            {"detour_angle", robot.detour_angle},
            {"held_by", held_by}};
  if (robot.passage) json["passage"] = {robot.passage->x, robot.passage->y};
  if (robot.distance_left > 0.0) json["distance_left"] = robot.distance_left;
  return json;
}

// Returns the metrics in the order of docs/metrics.md.
Json to_json(const avo::RunMetrics& metrics) {
  Json json;
  json["trips"] = metrics.trips;
  json["collision_robot_steps"] = metrics.collision_robot_steps;
  json["overlap_depth"] = metrics.overlap_depth;
  json["success"] = or_null(metrics.success);
  json["collision"] = or_null(metrics.collision);
  json["timeout"] = or_null(metrics.timeout);
  json["extra_time_mean"] = or_null(metrics.extra_time_mean);
  json["extra_time_p75"] = or_null(metrics.extra_time_p75);
  json["extra_time_p90"] = or_null(metrics.extra_time_p90);
  json["flowtime"] = or_null(metrics.flowtime);
  json["path_ratio"] = or_null(metrics.path_ratio);
  json["effort"] = or_null(metrics.effort);
  json["acceleration_rms"] = or_null(metrics.acceleration_rms);
  json["jerk"] = or_null(metrics.jerk);
  json["reversals"] = or_null(metrics.reversals);
  json["turned_back"] = or_null(metrics.turned_back);
  json["efficacy"] = or_null(metrics.efficacy);
  json["deadlock_time"] = or_null(metrics.deadlock_time);
  json["step_ms_p50"] = or_null(metrics.step_ms_p50);
  json["step_ms_p99"] = or_null(metrics.step_ms_p99);
  json["danger"] = or_null(metrics.danger);
  json["danger_separation"] = or_null(metrics.danger_separation);
  json["order"] = or_null(metrics.order);
  json["density_mean"] = or_null(metrics.density_mean);
  json["density_max"] = or_null(metrics.density_max);
  json["flow"] = or_null(metrics.flow);
  json["specific_flow"] = or_null(metrics.specific_flow);
  json["crossing_times"] = metrics.crossing_times ? Json(*metrics.crossing_times) : Json();
  return json;
}

}  // namespace

std::string to_json(const avo::RunSummary& summary) {
  Json json;
  json["scene"] = summary.scene;
  json["robots"] = summary.robots;
  json["parked"] = summary.parked;
  json["steps"] = summary.steps;
  json["arrived"] = summary.arrived;
  json["first_collision_time"] = or_null(summary.first_collision_time);
  json["collision_pairs"] = summary.collision_pairs;
  json["one_sided_collisions"] = summary.one_sided_collisions;
  json["one_sided_collisions_in_motion"] = summary.one_sided_collisions_in_motion;
  json["mover_collisions"] = summary.mover_collisions;
  json["mover_collisions_in_motion"] = summary.mover_collisions_in_motion;
  json["mover_collisions_evadable"] = or_null(summary.mover_collisions_evadable);
  json["static_collisions"] = summary.static_collisions;
  json["min_clearance"] = or_null(summary.min_clearance);
  json["min_static_clearance"] = or_null(summary.min_static_clearance);
  json["first_seen_too_late"] = or_null(summary.first_seen_too_late);
  json["max_acceleration"] = summary.max_acceleration;
  json["acceleration_excess"] = summary.acceleration_excess;
  json["max_speed"] = summary.max_speed;
  json["mean_arrival"] = or_null(summary.mean_arrival);
  json["last_arrival"] = or_null(summary.last_arrival);
  json["infeasible_steps"] = summary.infeasible_steps;
  json["decisions"] = to_json(summary.decisions);
  json["not_arrived_count"] = summary.robots - summary.arrived;
  json["not_arrived"] = Json::array();
  for (const avo::NotArrived& entry : summary.not_arrived)
    json["not_arrived"].push_back(to_json(entry));
  json["unreachable"] = summary.unreachable;
  json["step_milliseconds_median"] = or_null(summary.step_milliseconds_median);
  json["metrics"] = to_json(summary.metrics);
  json["seed"] = summary.seed;
  json["version"] = avo::kVersion;
  // the scene may have the name of its file, which may be no UTF-8
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace avo_io
