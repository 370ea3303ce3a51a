// SPDX-License-Identifier: Apache-2.0
// Takes the members of definitions to those of C++, and back, by one list for both directions.
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "convert.h"
#include "definitions.h"
#include "space_convert.h"

namespace avo_c {

/// Numbers of enumerators, as C counts them.
template <typename Word>
inline constexpr std::int32_t kWords = 2;
template <>
inline constexpr std::int32_t kWords<avo::Method> = 9;
template <>
inline constexpr std::int32_t kWords<avo::Certificate> = 3;
template <>
inline constexpr std::int32_t kWords<avo::Behavior> = 4;

/// A member of a definition by its name, for messages.
struct Named {
  const Where& where;
  const char* member;
};

inline void take(avo::Vec2& to, avo_vec2 from, const Named&) {
  to = from_c(from);
}
inline void take(avo::Vec3& to, avo_vec3 from, const Named&) {
  to = from_c(from);
}
inline void take(avo::LayerSet& to, std::uint32_t from, const Named&) {
  to.bits = from;
}
inline void take(avo::SensingError& to, avo_sensing_error from, const Named&) {
  to = {from.position, from.velocity};
}
/// Whether a number stands for a number that is unset; both may be NaN.
inline bool is_unset(double number, double unset) {
  return number == unset || (std::isnan(number) && std::isnan(unset));
}
/// A word, or AVO_UNSET. `unset` stands for a number that is unset.
template <typename Value, typename C>
void take(Value& to, C from, const Named& named) {
  if constexpr (std::is_enum_v<Value>)
    to = word<Value>(from, kWords<Value>, named.where, named.member);
  else
    to = from;
}
template <typename Value, typename C>
void take(std::optional<Value>& to, C from, const Named& named, double unset = 0.0) {
  if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
    to = is_unset(from, unset) ? std::nullopt : std::optional<Value>(from);
  } else if (static_cast<std::int32_t>(from) == AVO_UNSET) {
    to.reset();
  } else if constexpr (std::is_same_v<Value, bool>) {
    to = word<std::int32_t>(from, 2, named.where, named.member) == 1;
  } else {
    take(to.emplace(), from, named);
  }
}

inline void give(avo_vec2& to, avo::Vec2 from) {
  to = to_c(from);
}
inline void give(avo_vec3& to, avo::Vec3 from) {
  to = to_c(from);
}
inline void give(std::uint32_t& to, avo::LayerSet from) {
  to = from.bits;
}
inline void give(avo_sensing_error& to, avo::SensingError from) {
  to = {from.position, from.velocity};
}
template <typename C, typename Value>
void give(C& to, const Value& from) {
  to = static_cast<C>(from);
}
template <typename C, typename Value>
void give(C& to, const std::optional<Value>& from, double unset = 0.0) {
  constexpr bool is_number = std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>;
  to = from ? static_cast<C>(*from) : static_cast<C>(is_number ? unset : double{AVO_UNSET});
}

/// Members of a definition Def and of C++'s Own that have one name. `for_each` lists them by
/// visit(name, member in C, member in C++). If the number for none is not 0, it is the next
/// argument.
template <typename Def, typename Own, typename ForEach>
void take_members(const Def& def, Own& own, const Where& where, const ForEach& for_each) {
  for_each([&](const char* name, auto in_c, auto member, auto... unset) {
    take(own.*member, def.*in_c, {where, name}, unset...);
  });
}
template <typename Def, typename Own, typename ForEach>
void give_members(const Own& own, Def& def, const ForEach& for_each) {
  for_each([&](const char*, auto in_c, auto member, auto... unset) {
    give(def.*in_c, own.*member, unset...);
  });
}

}  // namespace avo_c
