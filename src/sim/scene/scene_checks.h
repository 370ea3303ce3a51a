// SPDX-License-Identifier: Apache-2.0
// The common part of the checks of a scene: the text of points.
#pragma once

#include <charconv>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include "avo/scenario.h"
#include "core/ranges.h"
#include "fields/place.h"

namespace avo::inline sim {

using core::text;

/// Where a scene with a robot that cannot stop is refused.
inline constexpr const char* kAmongFlights = " in a scene with airplanes";

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

/// Refuses robot i of the scene if no robot of its model can have its values.
void check_robot(std::size_t i, const RobotSetup& robot, double time_step);
/// Refuses a footprint that the robot's model cannot have.
void check_footprint(std::size_t i, const RobotSetup& robot);
/// Refuses what robots with footprints cannot keep apart with.
void check_footprints(const Scenario& scenario);
void check_external(const Scenario& scenario);
void check_obstacles(const Scenario& scenario);
void check_teams(const Scenario& scenario);

/// The effect of the rest of a step on a state that is seen during the step, for free clocks
/// (docs/certificate/clocks.md, "Robots with wheels"). It excludes the effect of max_acceleration
/// on the velocity of the disc.
SensingError unforeseen(const Scenario& scenario);

/// m: evasive maneuvers before movers need all walls within their reach.
inline double wall_range(bool has_movers) {
  return has_movers ? std::numeric_limits<double>::infinity() : 0.0;
}

/// The values that all robots of a scene share, whatever their methods are.
struct Agreed {
  double longest_step = 0.0;  // s, of any robot
  SensingError declared;      // the error that robots with a certificate declare
};
Agreed agreed_on(const Scenario& scenario);
/// planner_options() of a robot, where the shared values are known.
PlannerOptions planner_options(const Scenario& scenario, const RobotSetup& robot,
                               const Agreed& agreed);

/// The options of the robots with a certificate, which all have one method; the scene's where there
/// are none.
PlannerOptions certified_options(const Scenario& scenario);
/// Clears a declared error without a certificate: the last robot with a certificate may be gone.
void forget_undeclared_error(Scenario& scenario);

}  // namespace avo::inline sim
