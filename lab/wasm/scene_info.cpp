// SPDX-License-Identifier: Apache-2.0
// The facts about a scene that do not change from step to step.
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
Json options_of(const avo::Scenario& scenario, const avo::Simulation& simulation) {
  Json json;
  for (const auto& field : avo_io::fields<avo::Scenario>()) {
    std::visit(
        [&](const auto member) {
          if constexpr (!std::is_same_v<decltype(member), const std::monostate>)
            json[std::string(field.key)] = shown(scenario.*member);
        },
        field.member);
  }
  json["certificate"] = to_string(simulation.planner().options().certificate);
  json["sensing_radius"] = simulation.sensing_radius();
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
                      {"parked", robot.parked},
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

}  // namespace

/// Returns JSON.
AVO_EXPORT(std::size_t, info)() {
  const auto& [scenario, start, simulation, metrics] = lab();
  Json moving_obstacles = Json::array();
  for (const avo::MovingObstacle& obstacle : simulation->moving_obstacles().setup)
    moving_obstacles.push_back({{"radius", obstacle.radius}});
  const Json json{{"name", scenario.name},
                  {"duration", scenario.duration},
                  {"options", options_of(scenario, *simulation)},
                  {"robots", robots_of(simulation->fleet())},
                  {"walls", walls_of(simulation->obstacles())},
                  {"moving_obstacles", moving_obstacles},
                  {"advice", avo::advice(start)},
                  {"broken_assumptions", avo_io::complaints(start)}};
  return into_room(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace avo_lab
