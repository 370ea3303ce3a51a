// SPDX-License-Identifier: Apache-2.0
// Keys and values of scenes and options that earlier versions had, and what replaces them. Scene
// files, saved states and the bindings refuse them by this one table.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace avo::inline core {

/// A key that was removed with all its values, or one value of a key that remains.
struct Removed {
  std::string_view key;
  std::string_view value;  ///< the removed value; empty: the whole key
  int number;              ///< of the removed value, in C and in saved states
  std::string_view usual;  ///< of a removed key: its value in scenes that mean the same without it
  std::string_view instead;  ///< the value that replaces it, or for a key what holds now
};

inline constexpr Removed kRemoved[] = {
    {"certificate", "stopping_capsules", 1, "", "braking_trajectories"},
    {"right_of_way", "told", 2, "", "seen"},
    {"samples", "", 0, "0", "all half-planes are exact"},
    {"precision", "", 0, "double", "everything is computed in double precision"},
};

/// Returns the removed key itself; nullptr if there is none of that name.
constexpr const Removed* removed_key(std::string_view key) {
  for (const Removed& one : kRemoved)
    if (one.key == key && one.value.empty()) return &one;
  return nullptr;
}

/// Returns the removed value of a key by its number; nullptr if there is none.
constexpr const Removed* removed_value(std::string_view key, std::int64_t number) {
  for (const Removed& one : kRemoved)
    if (one.key == key && !one.value.empty() && one.number == number) return &one;
  return nullptr;
}

/// Returns what a message says that it must be in place of it.
inline std::string allowed_instead(const Removed& one) {
  const std::string instead(one.instead);
  return one.value.empty() ? "left out: " + instead
                           : instead + ": " + std::string(one.value) + " was removed";
}

}  // namespace avo::inline core
