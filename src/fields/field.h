// SPDX-License-Identifier: Apache-2.0
// The table of fields of the public structs: key, member, range, unit and one line of text. Scene
// files, checks of ranges, saved states and the bindings read it. Default values are those of the
// structs themselves.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/vec3.h"
#include "core/ranges.h"
#include "fields/place.h"

namespace avo::inline fields {

/// The kinds of values that the fields of T may have, by default those that many structs have. A
/// value with keys of its own, which code reads, is a std::monostate.
template <class T, class... Kinds>
using MemberOf = std::variant<std::monostate, Kinds T::*...>;
template <class T>
struct MembersOf {
  using type = MemberOf<T, double, std::optional<double>, int, bool, std::string, Vec2, Vec3,
                        std::vector<Vec2>, LayerSet, Fill>;
};
template <>
struct MembersOf<RobotSetup> {
  using type = MemberOf<RobotSetup, double, std::optional<double>, Vec2, LayerSet, Behavior,
                        std::optional<Method>>;
};
template <>
struct MembersOf<MovingObstacle> {
  using type = MemberOf<MovingObstacle, double, std::optional<double>, Vec2, std::vector<Vec2>,
                        std::vector<TimedPlace>>;
};
template <>
struct MembersOf<Car> {
  using type = MemberOf<Car, double, std::optional<double>, bool, AccelerationSet>;
};
template <>
struct MembersOf<Airplane> {
  using type = MemberOf<Airplane, double, AfterGoal>;
};
template <>
struct MembersOf<Scenario> {
  using type = MemberOf<Scenario, double, std::optional<double>, int, std::optional<int>,
                        std::uint64_t, std::string, Method, std::optional<Certificate>, Motion,
                        bool, std::optional<bool>, RightOfWay, Clock>;
};
template <>
struct MembersOf<MeasurementNoise> {
  using type = MemberOf<MeasurementNoise, double, std::optional<double>, NoiseDistribution>;
};
template <>
struct MembersOf<LocalizationNoise> {
  using type = MemberOf<LocalizationNoise, double, std::optional<double>, NoiseDistribution>;
};

template <>
struct MembersOf<ExecutionModel> {
  using type = MemberOf<ExecutionModel, double>;
};

enum class Need : std::uint8_t { required, optional };
inline constexpr Need kRequired = Need::required;
inline constexpr Need kOptional = Need::optional;

/// Which robots may have another value than the default: a parked robot decides nothing.
enum class Whose : std::uint8_t { all, deciding };
inline constexpr Whose kDeciding = Whose::deciding;

/// Whether a field says only what a robot wants: no certificate and no other robot counts on it.
enum class Says : std::uint8_t { what_it_does, what_it_wants };
inline constexpr Says kWants = Says::what_it_wants;

template <class T, class Member = typename MembersOf<T>::type>
struct Field {
  std::string_view key;
  Member member;
  Need need = Need::optional;
  Range range = {};       ///< of numbers; of both components of points; of the byte counts of texts
  std::string_view unit;  ///< empty: none
  std::string_view doc;   ///< one line
  std::string_view default_text = "";  ///< if the default is not the struct's value
  Whose whose = Whose::all;
  Says says = Says::what_it_does;
};

/// The fields of T, in the order of the documentation. The template is hidden explicitly: the
/// instances of public structs would be exported.
template <class T>
AVO_LOCAL inline constexpr std::monostate kFields{};

/// The row of a field that another struct has as well, with the same meaning. Only its default may
/// be another one. A key that the other struct does not have does not compile.
template <class Other, class T, class Value>
consteval Field<T> as_in(std::string_view key, Value T::*member,
                         std::optional<std::string_view> default_text = {}) {
  const auto& table = kFields<Other>;
  const auto row =
      std::find_if(table.begin(), table.end(), [&](const auto& field) { return field.key == key; });
  return {row->key,
          member,
          row->need,
          row->range,
          row->unit,
          row->doc,
          default_text.value_or(row->default_text),
          row->whose,
          row->says};
}

/// Fields with keys of their own; ranges of layers, and of values that are not numbers.
inline constexpr std::monostate kNested;
inline constexpr Range kLayer{0.0, 31.0, false};
inline constexpr Range kNoNumber{};

/// visit(field, member) for each field of a table that has a member, in the table's order.
template <class Table, class Visit>
void for_each_member(const Table& table, const Visit& visit) {
  for (const auto& field : table)
    std::visit(
        [&](const auto member) {
          if constexpr (!std::is_same_v<decltype(member), const std::monostate>)
            visit(field, member);
        },
        field.member);
}

/// Copies the fields that say only what a robot wants.
template <class T>
void copy_wants(const T& from, T& to) {
  for_each_member(kFields<T>, [&](const auto& field, const auto member) {
    if (field.says == kWants) to.*member = from.*member;
  });
}

/// Throws Error for the first number of the value that is outside of its field's range. name(key):
/// the number's name, of any type that converts to a string.
template <class T, class Name>
void require_ranges(const T& value, const Name& name) {
  for_each_member(kFields<T>, [&](const auto& field, const auto member) {
    const auto& own = value.*member;
    using Value = std::decay_t<decltype(own)>;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int>)
      require(name(field.key), own, field.range, field.unit);
    else if constexpr (std::is_same_v<Value, Vec2> || std::is_same_v<Value, Vec3>)
      require(name(field.key), own, field.unit);
    else if constexpr (std::is_same_v<Value, std::optional<double>> ||
                       std::is_same_v<Value, std::optional<int>>)
      if (own) require(name(field.key), *own, field.range, field.unit);
  });
}

}  // namespace avo::inline fields
