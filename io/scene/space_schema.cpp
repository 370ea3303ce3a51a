// SPDX-License-Identifier: Apache-2.0
// The part of the JSON Schema for scenes of space. Modules without io/space have it as well.
#include <utility>

#include "io/scene/schema_parts.h"

namespace avo_io {
namespace {

using avo::space::MovingObstacle;
using avo::space::RobotSetup;

Json space_robot_schema() {
  return map_schema(fields<RobotSetup>(),
                    {{"quadrotor", map_schema(fields<avo::space::Quadrotor>())}});
}

// A group has the keys of its robots but their places.
Json space_group_schema() {
  Json offset{{"type", "object"}, {"additionalProperties", false}, {"required", {"offset"}}};
  offset["properties"]["offset"] = map_schema(fields<SpaceOffset>());
  const Json goal{
      {"oneOf", Json::array({Json{{"enum", {"antipodal", "permuted"}}}, std::move(offset)})}};
  Json json = map_schema(fields<SpaceGroup>(), {{"sphere", map_schema(fields<SpherePlacement>())},
                                                {"box", map_schema(fields<BoxPlacement>())},
                                                {"grid", map_schema(fields<SpaceGridPlacement>())},
                                                {"goal", goal}});
  json["oneOf"] = maps_with({"sphere", "box", "grid"});
  const Json robot = space_robot_schema();
  for (const auto& [key, value] : robot["properties"].items())
    if (key != "position" && key != "goal") json["properties"][key] = value;
  return json;
}

Json space_mover_schema() {
  const Json places{{"type", "array"}, {"items", point_schema(avo::kAnyValue, 4)}, {"minItems", 1}};
  Json json = map_schema(fields<MovingObstacle>(), {{"trajectory", places}});
  json["oneOf"] = maps_with({"position", "trajectory"});
  return json;
}

// An obstacle with one key, or one of the plane with `height`, without what robots of the plane
// alone heed.
Json space_obstacle_schema(const Json& plane_obstacles) {
  const Json height = number_schema(avo::kAnyValue);
  Json forms = Json::array();
  const auto add = [&](const char* key, const Json& value) {
    forms.push_back({{"type", "object"},
                     {"properties", {{key, value}}},
                     {"additionalProperties", false},
                     {"required", Json::array({key})}});
  };
  add("floor", height);
  add("ceiling", height);
  add("box", map_schema(fields<SpaceBox>()));
  for (Json form : plane_obstacles["oneOf"]) {
    for (const char* key : {"layers", "solid", "as"}) form["properties"].erase(key);
    form["properties"]["height"] = point_schema(avo::kAnyValue);
    forms.push_back(std::move(form));
  }
  return {{"oneOf", forms}};
}

}  // namespace

Json space_definitions(const Json& plane_obstacles) {
  Json sensing = map_schema(fields<avo::SensingModel>(),
                            {{"noise", map_schema(fields<avo::MeasurementNoise>())},
                             {"localization", map_schema(fields<avo::LocalizationNoise>())}});
  Json scene = map_schema(fields<avo::space::Scenario>(),
                          {{"version", {{"const", 1}}},
                           {"space", {{"const", 3}}},
                           {"sensing", sensing},
                           {"sensing_error", map_schema(fields<avo::SensingError>())},
                           {"robots", list_schema("space_robot")},
                           {"groups", list_schema("space_group")},
                           {"moving_obstacles", list_schema("space_moving_obstacle")},
                           {"obstacles", list_schema("space_obstacle")}});
  scene["anyOf"] = maps_with({"robots", "groups"});
  return {{"space", scene},
          {"space_robot", space_robot_schema()},
          {"space_group", space_group_schema()},
          {"space_moving_obstacle", space_mover_schema()},
          {"space_obstacle", space_obstacle_schema(plane_obstacles)}};
}

}  // namespace avo_io
