// SPDX-License-Identifier: Apache-2.0
// The table of fields as JSON Schema (draft 2020-12), for editors and other programs.
#include <fmt/format.h>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "avo_io/scene.h"
#include "io/fields/fields.h"
#include "io/fields/kinds.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

Json number_schema(const avo::Range& range) {
  Json json{{"type", "number"}};
  json[range.open_min ? "exclusiveMinimum" : "minimum"] = range.min;
  json["maximum"] = range.max;
  return json;
}

Json whole_number_schema(const avo::Range& range) {
  Json json{{"type", "integer"}};
  json["minimum"] = static_cast<std::int64_t>(range.min);
  if (range.max < 9e18)
    json["maximum"] = static_cast<std::int64_t>(range.max);
  else
    json["maximum"] = UINT64_MAX;
  return json;
}

Json point_schema(const avo::Range& range) {
  return {{"type", "array"},
          {"prefixItems", {number_schema(range), number_schema(range)}},
          {"items", false},
          {"minItems", 2}};
}

template <class Names>
Json names_schema(const Names& names) {
  Json json = Json::array();
  for (const auto& [name, value] : names) json.push_back(name);
  return {{"enum", json}};
}

template <class Names, class Value>
std::string value_name(const Names& names, Value value) {
  for (const auto& [name, candidate] : names)
    if (candidate == value) return std::string(name);
  return "";
}

/// The schema of one value, and its default.
struct ValueSchema {
  Json schema, default_value;
};
ValueSchema describe(double value, const avo::Range& range) {
  return {number_schema(range), value};
}
ValueSchema describe(const std::optional<double>&, const avo::Range& range) {
  return {number_schema(range), nullptr};
}
ValueSchema describe(int value, const avo::Range& range) {
  return {whole_number_schema(range), value};
}
ValueSchema describe(const std::optional<int>&, const avo::Range& range) {
  return {whole_number_schema(range), nullptr};
}
ValueSchema describe(std::uint64_t value, const avo::Range& range) {
  return {whole_number_schema(range), value};
}
ValueSchema describe(const std::string& value, const avo::Range& range) {
  return {{{"type", "string"},
           {"minLength", static_cast<std::int64_t>(range.min)},
           {"maxLength", static_cast<std::int64_t>(range.max)}},
          value};
}
ValueSchema describe(avo::Vec2 value, const avo::Range& range) {
  return {point_schema(range), Json::array({value.x, value.y})};
}
ValueSchema describe(avo::Method value, const avo::Range&) {
  return {names_schema(kMethods), value_name(kMethods, value)};
}
ValueSchema describe(const std::optional<avo::Method>&, const avo::Range&) {
  return {names_schema(kMethods), nullptr};
}
ValueSchema describe(avo::Motion value, const avo::Range&) {
  return {names_schema(kMotions), value_name(kMotions, value)};
}
ValueSchema describe(avo::Clock value, const avo::Range&) {
  return {names_schema(kClocks), value_name(kClocks, value)};
}
ValueSchema describe(avo::RightOfWay value, const avo::Range&) {
  return {names_schema(kRightsOfWay), value_name(kRightsOfWay, value)};
}
ValueSchema describe(avo::NoiseDistribution value, const avo::Range&) {
  return {names_schema(kDistributions), value_name(kDistributions, value)};
}
ValueSchema describe(avo::AccelerationSet value, const avo::Range&) {
  return {names_schema(kAccelerationSets), value_name(kAccelerationSets, value)};
}
ValueSchema describe(avo::Behavior value, const avo::Range&) {
  return {names_schema(kBehaviors), value_name(kBehaviors, value)};
}
ValueSchema describe(avo::AfterGoal value, const avo::Range&) {
  return {names_schema(kAfterGoals), value_name(kAfterGoals, value)};
}
ValueSchema describe(avo::Formation value, const avo::Range&) {
  return {names_schema(kFormations), value_name(kFormations, value)};
}
ValueSchema describe(const std::optional<avo::Certificate>&, const avo::Range&) {
  return {names_schema(kCertificates), nullptr};
}

ValueSchema describe(bool value, const avo::Range&) {
  return {{{"type", "boolean"}}, value};
}
ValueSchema describe(avo::LayerSet value, const avo::Range& range) {
  Json layers = Json::array();
  for (int k = 0; k < 32; ++k)
    if ((value.bits >> k & 1U) != 0) layers.push_back(k);
  return {{{"type", "array"}, {"items", whole_number_schema(range)}, {"uniqueItems", true}},
          layers};
}
ValueSchema describe(const std::optional<bool>&, const avo::Range&) {
  return {{{"type", "boolean"}}, nullptr};
}
ValueSchema describe(avo::Fill value, const avo::Range&) {
  return {names_schema(kFills), value_name(kFills, value)};
}
ValueSchema describe(const std::vector<avo::TimedPlace>&, const avo::Range& range) {
  const Json number = number_schema(range);
  const Json place{{"type", "array"},
                   {"prefixItems", {number, number, number}},
                   {"items", false},
                   {"minItems", 3}};
  return {{{"type", "array"}, {"items", place}, {"minItems", 1}}, nullptr};
}
ValueSchema describe(const std::vector<avo::Vec2>&, const avo::Range& range) {
  return {{{"type", "array"}, {"items", point_schema(range)}, {"minItems", 2}}, nullptr};
}

template <class T>
Json value_schema(const Field<T>& field) {
  static const T defaults{};
  const auto visitor = [&](auto member) -> Json {
    if constexpr (std::is_same_v<decltype(member), std::monostate>) {
      return Json::object();
    } else {
      auto [schema, default_value] = describe(defaults.*member, field.range);
      if (field.need == Need::optional && field.default_text.empty())
        schema["default"] = default_value;
      return schema;
    }
  };
  return std::visit(visitor, field.member);
}

/// Returns the schema of a map with the fields of the table and no others; `nested` has the schemas
/// of values that have keys of their own.
template <class T>
Json map_schema(const std::vector<Field<T>>& table, const Json& nested = Json::object()) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const Field<T>& field : table) {
    const std::string key(field.key);
    std::string doc(field.doc);
    if (!field.unit.empty()) doc += fmt::format(" ({})", field.unit);
    if (!field.default_text.empty()) doc += fmt::format("; omitted: {}", field.default_text);
    Json json{{"description", doc}};
    json.update(nested.contains(key) ? nested[key] : value_schema(field));
    properties[key] = json;
    if (field.need == Need::required) required.push_back(key);
  }
  Json json{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) json["required"] = required;
  return json;
}

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

Json list_schema(const char* definition) {
  return {{"type", "array"}, {"items", {{"$ref", std::string("#/$defs/") + definition}}}};
}

/// Returns the schema of a body that is no disc: a rectangle or a polygon.
Json footprint_schema() {
  Json json = map_schema(fields<FootprintShape>());
  json["properties"]["polygon"]["minItems"] = 3;
  json["oneOf"] = {{{"required", {"length", "width"}}}, {{"required", {"polygon"}}}};
  return json;
}

/// Returns the schemas of the keys of a robot's motion.
Json nested_of_robots(const Json& heading) {
  Json car = map_schema(fields<avo::Car>(), {{"body", map_schema(fields<avo::CarBody>())}});
  car["properties"]["heading"] = heading;
  return {{"model", names_schema(kModels)},
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
  Json ways = Json::array();
  for (const char* key : {"position", "trajectory", "trajectory_file"})
    ways.push_back({{"required", Json::array({key})}});
  json["oneOf"] = ways;
  return json;
}

Json schema() {
  const Json alike = alike_schema();
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "avo scene"},
            {"description", "Robots, obstacles, and how they are simulated. SI units."}};
  json.update(map_schema(
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
       {"obstacles", list_schema("obstacle")}}));
  json["anyOf"] = {
      {{"required", {"robots"}}, {"properties", {{"robots", {{"minItems", 1}}}}}},
      {{"required", {"groups"}}, {"properties", {{"groups", {{"minItems", 1}}}}}},
      {{"required", {"robots_from"}}},
  };
  const Json heading = number_schema(kHeadingField.range);
  json["$defs"] = {{"robot", map_schema(fields<avo::RobotSetup>(), nested_of_robots(heading))},
                   {"group", group_schema(alike)},
                   {"moving_obstacle", moving_obstacle_schema()},
                   {"obstacle", entry_schema(static_cast<const ObstacleEntry*>(nullptr))}};
  return json;
}

}  // namespace

std::string scenario_schema() {
  return schema().dump(2) + "\n";
}

std::vector<SceneSetting> scene_settings() {
  std::vector<SceneSetting> settings;
  const Json all = schema();
  for (const auto& [key, value] : all["properties"].items()) {
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
