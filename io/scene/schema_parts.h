// SPDX-License-Identifier: Apache-2.0
// Tables of fields as JSON Schema (draft 2020-12).
#pragma once
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/fields/fields.h"
#include "io/text/json.h"

namespace avo_io {

inline Json number_schema(const avo::Range& range) {
  Json json{{"type", "number"}};
  json[range.open_min ? "exclusiveMinimum" : "minimum"] = range.min;
  json["maximum"] = range.max;
  return json;
}

inline Json whole_number_schema(const avo::Range& range) {
  Json json{{"type", "integer"}};
  json["minimum"] = static_cast<std::int64_t>(range.min);
  if (range.max < 9e18)
    json["maximum"] = static_cast<std::int64_t>(range.max);
  else
    json["maximum"] = UINT64_MAX;
  return json;
}

inline Json point_schema(const avo::Range& range, std::size_t numbers = 2) {
  return {{"type", "array"},
          {"prefixItems", Json::array_t(numbers, number_schema(range))},
          {"items", false},
          {"minItems", numbers}};
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
inline ValueSchema describe(double value, const avo::Range& range) {
  return {number_schema(range), value};
}
inline ValueSchema describe(int value, const avo::Range& range) {
  return {whole_number_schema(range), value};
}
inline ValueSchema describe(std::uint64_t value, const avo::Range& range) {
  return {whole_number_schema(range), value};
}
inline ValueSchema describe(const std::string& value, const avo::Range& range) {
  return {{{"type", "string"},
           {"minLength", static_cast<std::int64_t>(range.min)},
           {"maxLength", static_cast<std::int64_t>(range.max)}},
          value};
}
inline ValueSchema describe(avo::Vec2 value, const avo::Range& range) {
  return {point_schema(range), Json::array({value.x, value.y})};
}
inline ValueSchema describe(avo::Vec3 value, const avo::Range& range) {
  return {point_schema(range, 3), Json::array({value.x, value.y, value.z})};
}
template <class Choice>
requires std::is_enum_v<Choice> ValueSchema describe(Choice value, const avo::Range&) {
  return {names_schema(kWords<Choice>), value_name(kWords<Choice>, value)};
}
inline ValueSchema describe(bool value, const avo::Range&) {
  return {{{"type", "boolean"}}, value};
}
inline ValueSchema describe(avo::LayerSet value, const avo::Range& range) {
  Json layers = Json::array();
  for (int k = 0; k < 32; ++k)
    if ((value.bits >> k & 1U) != 0) layers.push_back(k);
  return {{{"type", "array"}, {"items", whole_number_schema(range)}, {"uniqueItems", true}},
          layers};
}
inline ValueSchema describe(const std::vector<avo::TimedPlace>&, const avo::Range& range) {
  return {{{"type", "array"}, {"items", point_schema(range, 3)}, {"minItems", 1}}, nullptr};
}
inline ValueSchema describe(const std::vector<avo::Vec2>&, const avo::Range& range) {
  return {{{"type", "array"}, {"items", point_schema(range)}, {"minItems", 2}}, nullptr};
}

template <class Value>
ValueSchema describe(const std::optional<Value>&, const avo::Range& range) {
  return {describe(Value{}, range).schema, nullptr};
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

/// Returns the schema of a map with the fields of the table and no others. `nested` has the schemas
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

inline Json list_schema(const char* definition) {
  return {{"type", "array"}, {"items", {{"$ref", std::string("#/$defs/") + definition}}}};
}

/// Returns schemas of maps that have this key, for each of the keys.
inline Json maps_with(std::initializer_list<const char*> keys) {
  Json maps = Json::array();
  for (const char* key : keys) maps.push_back({{"required", Json::array({key})}});
  return maps;
}

/// The definitions that a schema of space names, `space` the scene itself. plane_obstacles: the
/// schemas of the obstacles of the plane.
Json space_definitions(const Json& plane_obstacles);

}  // namespace avo_io
