// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind: a table of all states, and one object of results.
#include "avo_io/recording.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "avo/checked.h"
#include "avo/version.h"

namespace avo_io {
namespace {

using Json = nlohmann::ordered_json;

template <typename Number>
Json or_null(const std::optional<Number>& value) {
  return value ? Json(*value) : Json();
}

Json to_json(const avo::Decisions& decisions) {
  return {{"optimal", decisions.optimal},         {"least_unsafe", decisions.least_unsafe},
          {"candidate", decisions.candidate},     {"braking", decisions.braking},
          {"overlapping", decisions.overlapping}, {"invalid_input", decisions.invalid_input}};
}

/// Robot I, or moving obstacle K as "moving_obstacles.K".
Json name_of(std::int64_t source) {
  if (source >= 0) return source;
  return fmt::format("moving_obstacles.{}", -1 - source);
}

Json to_json(const avo::NotArrived& robot) {
  Json held_by = Json::array();
  for (const std::int64_t entry : robot.held_by) held_by.push_back(name_of(entry));
  return {{"robot", robot.robot},   {"distance", robot.distance},
          {"speed", robot.speed},   {"status", avo::to_string(robot.status)},
          {"detour", robot.detour}, {"held_by", held_by}};
}

}  // namespace

bool has_headings(const avo::Scenario& scenario) {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(),
                     [](const avo::RobotSetup& robot) { return !is_holonomic(robot.model); });
}

CsvRecording::CsvRecording(const std::string& path, bool headings, std::int64_t every)
    : file_(path), headings_(headings), every_(every) {
  file_.write(fmt::format("time,robot,x,y,vx,vy{}{}\n", headings ? ",heading,speed" : "",
                          every > 1 ? ",every" : ""));
}

void CsvRecording::add(const avo::Simulation& simulation) {
  fmt::memory_buffer row;
  const auto end = std::back_inserter(row);
  for (const avo::CheckedState& state : checked_states(simulation.fleet())) {
    const avo::Vec2 p = state.position, v = state.velocity;
    row.clear();
    fmt::format_to(end, "{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g}", simulation.time(),
                   state.robot, p.x, p.y, v.x, v.y);
    if (headings_ && state.heading)
      fmt::format_to(end, ",{},{}", state.heading->angle, state.heading->speed);
    else if (headings_)
      fmt::format_to(end, ",,");
    if (every_ > 1) fmt::format_to(end, ",{}", every_);
    row.push_back('\n');
    file_.write({row.data(), row.size()});
  }
}

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
  json["obstacle_collisions"] = summary.obstacle_collisions;
  json["obstacle_collisions_in_motion"] = summary.obstacle_collisions_in_motion;
  json["collision_obstacles"] = summary.collision_obstacles;
  json["min_clearance"] = or_null(summary.min_clearance);
  json["min_obstacle_clearance"] = or_null(summary.min_obstacle_clearance);
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
  json["seed"] = summary.seed;
  json["version"] = avo::kVersion;
  // the scene may be called like its file, whose name need not be UTF-8
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace avo_io
