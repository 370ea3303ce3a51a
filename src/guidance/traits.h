// SPDX-License-Identifier: Apache-2.0
// What a robot can do, as far as it does not change from step to step.
#pragma once
#include <algorithm>
#include <numbers>
#include <optional>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "robots/model.h"

namespace avo::inline guidance {

struct RobotTraits {
  double radius = 0.0;            // m, of its disc
  double route_radius = 0.0;      // m, of each disc of its footprint: the room that its route needs
  double max_speed = 0.0;         // m/s
  double max_acceleration = 0.0;  // m/s^2
  double max_braking = 0.0;       // m/s^2
  double preferred_speed = 0.0;   // m/s
  bool has_model = false;         // it is not holonomic
  bool exceeds = false;           // it may accelerate by more than max_acceleration
};
/// The traits of a robot with that preferred speed, m/s.
inline RobotTraits traits_of(const Robot& robot, double preferred_speed) {
  return {.radius = robot.radius,
          .route_radius = route_radius(robot.model, robot.radius),
          .max_speed = robot.max_speed,
          .max_acceleration = robot.max_acceleration,
          .max_braking = braking_limit(robot),
          .preferred_speed = preferred_speed,
          .has_model = !is_holonomic(robot.model),
          .exceeds = model_traits(robot.model).reach > 1.0};
}
/// m, from its position to the farthest center of its footprint.
inline double reach_of(const RobotTraits& traits) {
  return traits.radius - traits.route_radius;
}
inline Ability ability_of(const RobotTraits& traits) {
  return {traits.max_acceleration, traits.max_braking};
}
/// See planned_braking() in avo/robot.h.
inline double planned_braking(const RobotTraits& traits) {
  return std::min(traits.max_acceleration, traits.max_braking);
}
/// See Robot::max_braking; unset where it brakes with its max_acceleration.
inline std::optional<double> max_braking_of(const RobotTraits& traits) {
  if (traits.max_braking == traits.max_acceleration) return std::nullopt;
  return traits.max_braking;
}

/// m/s²: the largest change of its velocity in a second.
inline double top_acceleration(const RobotTraits& traits) {
  const double reach = traits.exceeds ? std::numbers::sqrt2 : 1.0;
  return std::max(reach * traits.max_acceleration, traits.max_braking);
}

/// m, from its goal: a robot that maneuvers finds its own path within this distance. model: none
/// for a holonomic robot.
inline double own_path_of(const MotionModel* model) {
  constexpr double kOwnPath = 0.6;  // of its room for maneuvers
  return model != nullptr ? kOwnPath * model_traits(*model).maneuver_room : 0.0;
}

}  // namespace avo::inline guidance
