// SPDX-License-Identifier: Apache-2.0
// A robot's own space, in which z is divided by `vertical`. Its limits are balls there, and braking
// knows no directions (docs/space.md, "Unequal limits").
#pragma once
#include <algorithm>

#include "avo/robot.h"
#include "avo/space/robot.h"
#include "space/program.h"

namespace avo::space {

inline Vec3 to_own(Vec3 a, double vertical) {
  return {a.x, a.y, a.z / vertical};
}
inline Vec3 from_own(Vec3 a, double vertical) {
  return {a.x, a.y, a.z * vertical};
}

/// The same points in the robot's own space. Requires a normal that is not 0.
inline HalfSpace to_own(const HalfSpace& half_space, double vertical) {
  const Vec3 normal = from_own(half_space.normal, vertical);
  const double length = norm(normal);
  return {normal / length, half_space.offset / length};
}

/// [ν] of a velocity, m/s: its length in the robot's own space.
inline double own_length(Vec3 a, double vertical) {
  return norm(to_own(a, vertical));
}

inline double braking_limit(const Robot& robot) {
  return robot.max_braking.value_or(robot.max_acceleration);
}
inline double braking_limit(const Neighbor& neighbor) {
  return neighbor.max_braking.value_or(neighbor.max_acceleration);
}
/// m/s²: how much a body can change its velocity in a second, in any direction.
template <typename Body>
double top_acceleration(const Body& body) {
  return std::max(body.max_acceleration, braking_limit(body)) * std::max(body.vertical, 1.0);
}
/// min(a_max, b), m/s²: the deceleration for what a robot foresees.
inline double planned_braking(const Robot& robot) {
  return std::min(robot.max_acceleration, braking_limit(robot));
}

/// The robot of the plane with the same numbers, for rules that read numbers alone.
inline avo::Robot numbers_of(const Robot& robot) {
  avo::Robot same;
  same.radius = robot.radius;
  same.max_acceleration = robot.max_acceleration;
  same.max_speed = robot.max_speed;
  same.distance_to_goal = robot.distance_to_goal;
  same.max_braking = robot.max_braking;
  return same;
}

}  // namespace avo::space
