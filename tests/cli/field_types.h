// SPDX-License-Identifier: Apache-2.0
// The names of the types of fields in C, Python and TypeScript.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fields/planner_fields.h"

namespace avo_test {

/// The names of a value's type.
struct Types {
  std::string_view c;
  std::string_view attribute = {}, argument = {}, script = {};  // of robots
};
template <class Value>
inline constexpr Types kTypes{};
template <>
inline constexpr Types kTypes<double>{"double", "_Number", "_Float", "number"};
template <>
inline constexpr Types kTypes<std::optional<double>>{"double", "_NumberOrNone", "_Float | None",
                                                     "number"};
template <>
inline constexpr Types kTypes<avo::Vec2>{"avo_vec2", "_Point", "_Pair", "[number, number]"};
template <>
inline constexpr Types kTypes<avo::Vec3>{"avo_vec3"};
template <>
inline constexpr Types kTypes<bool>{"bool", "bool", "bool", "boolean"};
template <>
inline constexpr Types kTypes<avo::LayerSet>{"uint32_t", "_Layers", "Sequence[int]", "number[]"};
template <>
inline constexpr Types kTypes<avo::Behavior>{"avo_behavior", "_Behavior", "_Behavior",
                                             R"("decides" | "cooperates" | "moves_on" | "parked")"};
template <>
inline constexpr Types kTypes<std::optional<avo::Method>>{"int32_t", "_Method | None",
                                                          "_Method | None", "string"};
template <>
inline constexpr Types kTypes<avo::AccelerationSet>{"avo_acceleration_set", "", "",
                                                    R"("incircle" | "exact")"};
template <>
inline constexpr Types kTypes<avo::AfterGoal>{"avo_after_goal", "", "", R"("loiter" | "leave")"};
template <>
inline constexpr Types kTypes<int>{"int32_t"};
template <>
inline constexpr Types kTypes<std::optional<int>>{"int32_t"};
template <>
inline constexpr Types kTypes<std::optional<bool>>{"int32_t"};
template <>
inline constexpr Types kTypes<std::uint64_t>{"uint64_t"};
template <>
inline constexpr Types kTypes<std::string>{"const char*"};
template <>
inline constexpr Types kTypes<avo::Method>{"avo_method"};
template <>
inline constexpr Types kTypes<avo::Certificate>{"avo_certificate"};
template <>
inline constexpr Types kTypes<std::optional<avo::Certificate>>{"avo_certificate"};
template <>
inline constexpr Types kTypes<avo::Motion>{"avo_motion"};
template <>
inline constexpr Types kTypes<avo::RightOfWay>{"avo_right_of_way"};
template <>
inline constexpr Types kTypes<avo::Clock>{"avo_clock"};
template <>
inline constexpr Types kTypes<avo::NoiseDistribution>{"avo_noise_distribution"};
template <>
inline constexpr Types kTypes<std::vector<avo::Vec2>>{"const avo_vec2*"};
template <>
inline constexpr Types kTypes<std::vector<avo::TimedPlace>>{"const avo_timed_place*"};

template <class T, class Value>
constexpr const Types& types_of(Value T::*) {
  return kTypes<Value>;
}

}  // namespace avo_test
