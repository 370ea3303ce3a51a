// SPDX-License-Identifier: Apache-2.0
// What the checks of a scene share: where a value stands, and how points are told.
#pragma once

#include <charconv>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include "avo/scenario.h"
#include "core/ranges.h"

namespace avo::inline sim {

using core::text;

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
/// max_acceleration does to the velocity of the disc; of free clocks
/// (docs/certificate/clocks.md, "Robots with wheels").
SensingError unforeseen(const Scenario& scenario);

/// m: ways out before movers need all walls within their reach.
inline double wall_range(bool has_movers) {
  return has_movers ? std::numeric_limits<double>::infinity() : 0.0;
}

/// What all robots of a scene have agreed on, whatever their methods are.
struct Agreed {
  double longest_step = 0.0;  // s, of anybody
  SensingError declared;      // that those declare who keep a certificate
};
Agreed agreed_on(const Scenario& scenario);
/// planner_options() of a robot, where what all have agreed on is known.
PlannerOptions planner_options(const Scenario& scenario, const RobotSetup& robot,
                               const Agreed& agreed);

/// Those of the robots that keep a certificate, which are all of one method; the scene's where
/// nobody does.
PlannerOptions certified_options(const Scenario& scenario);
/// An error is declared with a certificate alone. Who keeps one may not be in the scene (any more).
void forget_undeclared_error(Scenario& scenario);

}  // namespace avo::inline sim
