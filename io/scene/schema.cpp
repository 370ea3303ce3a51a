// SPDX-License-Identifier: Apache-2.0
// The JSON Schema of scene files, for editors and other programs.
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "avo_io/scene.h"
#include "io/fields/kinds.h"
#include "io/scene/schema_parts.h"

namespace avo_io {
namespace {

template <class Kind>
bool name_suffices() {
  for (const Field<Kind>& field : fields<Kind>())
    if (field.need == Need::required) return false;
  return true;
}

/// Returns the schema of one kind: its name alone, if that suffices, or a map with it as the only
/// key.
template <class... Kinds>
Json kinds_schema(const std::variant<Kinds...>*) {
  Json names = Json::array();
  Json properties = Json::object();
  const auto add = [&]<class Kind>(const Kind*) {
    const KindText text = kind_text<Kind>();
    if (name_suffices<Kind>()) names.push_back(text.key);
    Json json{{"description", text.doc}};
    json.update(map_schema(fields<Kind>()));
    properties[std::string(text.key)] = json;
  };
  (add(static_cast<const Kinds*>(nullptr)), ...);
  Json map{{"type", "object"},
           {"properties", properties},
           {"additionalProperties", false},
           {"minProperties", 1},
           {"maxProperties", 1}};
  if (names.empty()) return map;
  return {{"oneOf", Json::array({Json{{"enum", names}}, map})}};
}

/// Returns the schema of a body that is no disc: a rectangle or a polygon.
Json footprint_schema() {
  Json json = map_schema(fields<FootprintShape>());
  json["properties"]["polygon"]["minItems"] = 3;
  json["oneOf"] = {{{"required", {"length", "width"}}}, {{"required", {"polygon"}}}};
  return json;
}

/// Returns the schemas of the keys of a robot without a member of their own.
Json nested_of_robots(const Json& heading) {
  Json car = map_schema(fields<avo::Car>(), {{"body", map_schema(fields<avo::CarBody>())}});
  car["properties"]["heading"] = heading;
  return {{"parked", {{"type", "boolean"}}},
          {"model", names_schema(kModels)},
          {"heading", heading},
          {"car", car},
          {"drive", map_schema(fields<avo::DifferentialDrive>())},
          {"footprint", footprint_schema()},
          {"airplane", map_schema(fields<avo::Airplane>())}};
}

/// Returns the schema of the keys that many robots of the same kind share.
Json alike_schema() {
  const Json heading{
      {"description", "rad, counter-clockwise from +x; goal: towards it"},
      {"oneOf", Json::array({number_schema(avo::kAnyValue), names_schema(kHeadings)})},
      {"default", "goal"}};
  return map_schema(group_robot_fields(), nested_of_robots(heading));
}

Json group_schema(const Json& alike) {
  Json json = map_schema(fields<Group>(),
                         {{"placement", kinds_schema(static_cast<const Placement*>(nullptr))},
                          {"goals", kinds_schema(static_cast<const Goals*>(nullptr))},
                          {"task", kinds_schema(static_cast<const avo::TeamTask*>(nullptr))}});
  json["properties"].update(alike["properties"]);
  return json;
}

Json robots_from_schema(const Json& alike) {
  Json json = map_schema(fields<RobotsFrom>());
  json["properties"].update(alike["properties"]);
  json["properties"]["radius"].erase("default");
  json["properties"]["radius"]["description"] = "of its disc (m); omitted: 0.45 cells of the map";
  return json;
}

/// Returns the schema of one kind: a map with the fields of one of the tables.
template <class... Kinds>
Json entry_schema(const std::variant<Kinds...>*) {
  const Json nested{{"disc", map_schema(fields<avo::Disc>())}, {"wkt", {{"type", "string"}}}};
  Json kinds = Json::array({map_schema(fields<Kinds>(), nested)...});
  for (Json& kind : kinds)
    if (kind["properties"].contains("polygon")) kind["properties"]["polygon"]["minItems"] = 3;
  return {{"oneOf", kinds}};
}

/// Returns the schema of a moving obstacle; its start must be given in one of three forms.
Json moving_obstacle_schema() {
  Json json = map_schema(fields<avo::MovingObstacle>(),
                         {{"trajectory_file", {{"type", "string"}, {"minLength", 1}}}});
  json["oneOf"] = maps_with({"position", "trajectory", "trajectory_file"});
  return json;
}

/// Returns the schema of a scene of the plane, without definitions.
Json plane_schema(const Json& alike) {
  Json json = map_schema(
      fields<avo::Scenario>(),
      {{"version", {{"const", 1}}},
       {"robots", list_schema("robot")},
       {"groups", list_schema("group")},
       {"robots_from", robots_from_schema(alike)},
       {"sensing", map_schema(fields<avo::SensingModel>(),
                              {{"noise", map_schema(fields<avo::MeasurementNoise>())},
                               {"localization", map_schema(fields<avo::LocalizationNoise>())}})},
       {"sensing_error", map_schema(fields<avo::SensingError>())},
       {"execution", map_schema(fields<avo::ExecutionModel>())},
       {"moving_obstacles", list_schema("moving_obstacle")},
       {"obstacles", list_schema("obstacle")}});
  json["anyOf"] = {
      {{"required", {"robots"}}, {"properties", {{"robots", {{"minItems", 1}}}}}},
      {{"required", {"groups"}}, {"properties", {{"groups", {{"minItems", 1}}}}}},
      {{"required", {"robots_from"}}},
  };
  return json;
}

Json schema() {
  const Json alike = alike_schema(), heading = number_schema(kHeadingField.range);
  const Json obstacle = entry_schema(static_cast<const ObstacleEntry*>(nullptr));
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "avo scene"},
            {"description", "Robots, obstacles, and how they are simulated. SI units."},
            {"type", "object"},
            {"if", {{"properties", {{"space", {{"const", 3}}}}}, {"required", {"space"}}}},
            {"then", {{"$ref", "#/$defs/space"}}},
            {"else", plane_schema(alike)}};
  json["$defs"] = {{"robot", map_schema(fields<avo::RobotSetup>(), nested_of_robots(heading))},
                   {"group", group_schema(alike)},
                   {"moving_obstacle", moving_obstacle_schema()},
                   {"obstacle", obstacle}};
  json["$defs"].update(space_definitions(obstacle));
  return json;
}

}  // namespace

std::string scenario_schema() {
  return schema().dump(2) + "\n";
}

std::vector<SceneSetting> scene_settings() {
  std::vector<SceneSetting> settings;
  const Json plane = plane_schema(alike_schema());
  for (const auto& [key, value] : plane["properties"].items()) {
    const std::string type = value.value("type", "");
    if (type == "array" || type == "object" || key == "version") continue;
    SceneSetting setting{key, {}};
    if (value.contains("enum")) setting.values = value["enum"].get<std::vector<std::string>>();
    if (type == "boolean") setting.values = {"true", "false"};
    settings.push_back(std::move(setting));
  }
  return settings;
}

}  // namespace avo_io
