// SPDX-License-Identifier: Apache-2.0
// The facts about a scene that do not change from step to step.
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "avo/discs.h"
#include "avo_io/complaints.h"
#include "host.h"
#include "io/fields/fields.h"
#include "io/text/json.h"

namespace avo_lab {
namespace {

using avo_io::Json;

template <class Value>
Json shown(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return to_string(value);
  else
    return value;
}
template <class Value>
Json shown(const std::optional<Value>& value) {
  return value ? shown(*value) : Json();
}

/// Returns all keys of scenes that take plain values, with their values in this scene.
template <class Scenario>
Json options_of(const Scenario& scenario) {
  Json json;
  for (const auto& field : avo_io::fields<Scenario>()) {
    std::visit(
        [&](const auto member) {
          if constexpr (!std::is_same_v<decltype(member), const std::monostate>)
            json[std::string(field.key)] = shown(scenario.*member);
        },
        field.member);
  }
  return json;
}

const char* model_of(const avo::RobotSetup& robot) {
  const auto name = [](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (std::is_same_v<Model, avo::Car>) return "car";
    if constexpr (std::is_same_v<Model, avo::DifferentialDrive>) return "differential_drive";
    if constexpr (std::is_same_v<Model, avo::Airplane>) return "airplane";
    return "holonomic";
  };
  return std::visit(name, robot.model);
}

/// Returns null for a robot that is one disc.
Json footprint_of(const avo::RobotSetup& robot) {
  if (!avo::footprint_of(robot.model)) return {};
  Json ahead = Json::array();
  const std::vector<avo::Disc> discs = discs_at(robot, {}, 0.0);
  for (const avo::Disc& disc : discs) ahead.push_back(disc.center.x);
  return {{"radius", discs[0].radius}, {"ahead", ahead}};
}

Json robots_of(const avo::FleetView& fleet) {
  Json robots = Json::array();
  for (std::size_t k = 0; k < fleet.id.size(); ++k) {
    const avo::RobotSetup& robot = fleet.setup[k];
    robots.push_back({{"robot", fleet.id[k].value},
                      {"radius", robot.radius},
                      {"disc_radius", disc_radius(robot)},
                      {"disc_ahead", disc_center(robot.model, {}, 0.0).x},
                      {"footprint", footprint_of(robot)},
                      {"max_speed", robot.max_speed},
                      {"max_acceleration", robot.max_acceleration},
                      {"preferred_speed", robot.preferred_speed},
                      {"priority", robot.priority},
                      {"parked", is_parked(robot)},
                      {"model", model_of(robot)}});
  }
  return robots;
}

Json walls_of(const avo::StaticObstacleView& obstacles) {
  Json walls = Json::array();
  for (std::size_t k = 0; k < obstacles.id.size(); ++k)
    for (const avo::Wall& wall : avo::walls_of(obstacles.setup.subspan(k, 1)))
      walls.push_back({{"a", {wall.a.x, wall.a.y}},
                       {"b", {wall.b.x, wall.b.y}},
                       {"radius", wall.radius},
                       {"obstacle", obstacles.id[k].value}});
  return walls;
}

Json bound(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json corner(avo::Vec3 v) {
  return {bound(v.x), bound(v.y), bound(v.z)};
}

Json robots_of(const avo::space::Scenario& scenario) {
  Json robots = Json::array();
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) {
    const avo::space::Robot robot = robot_of(scenario.robots[k]);
    robots.push_back({{"robot", k},
                      {"radius", robot.radius},
                      {"disc_radius", robot.radius},
                      {"disc_ahead", 0.0},
                      {"footprint", Json()},
                      {"max_speed", robot.max_speed},
                      {"max_acceleration", robot.max_acceleration},
                      {"preferred_speed", scenario.robots[k].preferred_speed},
                      {"priority", robot.priority},
                      {"parked", false},
                      {"model", "holonomic"},
                      {"vertical", robot.vertical},
                      {"downwash", robot.downwash}});
  }
  return robots;
}

Json boxes_of(const avo::space::Scenario& scenario) {
  Json boxes = Json::array();
  for (std::size_t k = 0; k < scenario.boxes.size(); ++k) {
    const avo::space::Box& box = scenario.boxes[k];
    boxes.push_back({{"min", corner(box.min)},
                     {"max", corner(box.max)},
                     {"heading", box.heading},
                     {"radius", box.radius},
                     {"obstacle", obstacle_of(scenario, k)}});
  }
  return boxes;
}

}  // namespace

std::string info_of(const PlaneRun& run) {
  const auto& [scenario, start, simulation, metrics] = run;
  Json options = options_of(scenario);
  options["certificate"] = to_string(simulation->planner().options().certificate);
  options["sensing_radius"] = simulation->sensing_radius();
  Json moving_obstacles = Json::array();
  for (const avo::MovingObstacle& obstacle : simulation->moving_obstacles().setup)
    moving_obstacles.push_back({{"radius", obstacle.radius}});
  const Json json{{"dimensions", 2},
                  {"name", scenario.name},
                  {"duration", scenario.duration},
                  {"options", options},
                  {"robots", robots_of(simulation->fleet())},
                  {"walls", walls_of(simulation->obstacles())},
                  {"boxes", Json::array()},
                  {"moving_obstacles", moving_obstacles},
                  {"advice", avo::advice(start)},
                  {"broken_assumptions", avo_io::complaints(start)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string info_of(const SpaceRun& run) {
  const avo::space::Scenario& scenario = run.scenario;
  Json options = options_of(scenario);
  options["method"] = to_string(avo::Method::avo);
  const avo::PlannerOptions planner = planner_options(scenario);
  options["certificate"] = to_string(planner.certificate);
  options["control_time"] = planner.control_time;
  options["time_horizon"] = planner.time_horizon;
  options["sensing_radius"] = sensing_radius_of(scenario);
  Json moving_obstacles = Json::array();
  for (const avo::space::MovingObstacle& obstacle : scenario.moving_obstacles) {
    Json trajectory = Json::array();
    for (const auto& [time, place] : obstacle.trajectory)
      trajectory.push_back({time, place.x, place.y, place.z});
    moving_obstacles.push_back({{"radius", obstacle.radius},
                                {"position", corner(obstacle.position)},
                                {"velocity", corner(obstacle.velocity)},
                                {"acceleration", corner(obstacle.acceleration)},
                                {"trajectory", trajectory}});
  }
  const Json json{{"dimensions", 3},
                  {"name", scenario.name},
                  {"duration", scenario.duration},
                  {"options", options},
                  {"robots", robots_of(scenario)},
                  {"walls", Json::array()},
                  {"boxes", boxes_of(scenario)},
                  {"moving_obstacles", moving_obstacles},
                  {"advice", Json::array()},
                  {"broken_assumptions", Json::array()}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace avo_lab
