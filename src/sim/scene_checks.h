// SPDX-License-Identifier: Apache-2.0
// What the checks of a scene share: where a value stands, and how points are told.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "avo/scenario.h"
#include "core/ranges.h"

namespace avo {

/// A value's place in a list of the scene.
struct Place {
  std::string_view list;
  std::size_t index;
  std::string_view field;

  explicit operator std::string() const {
    return std::string(list) + "." + std::to_string(index) + "." + std::string(field);
  }
};

inline std::string text(Vec2 p) {
  return std::string("[").append(text(p.x)).append(", ").append(text(p.y)).append("]");
}

/// With so many digits.
inline std::string rounded(double value, int digits) {
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  return {buffer, end};
}

/// Refuses what no robot of its model can be, number i of the scene.
void check_robot(std::size_t i, const RobotSetup& robot, double time_step);

/// What the rest of a step adds to a state that is seen in the midst of it, beyond what
/// max_acceleration does to the velocity of the disc; of free clocks (docs/certificate.md, "Clocks
/// of their own").
SensingError unforeseen(const Scenario& scenario);

}  // namespace avo
