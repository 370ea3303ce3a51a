// SPDX-License-Identifier: Apache-2.0
// What a robot of space knows of itself and senses of the others (docs/space.md). SI units.
#pragma once
#include <limits>
#include <optional>

#include "avo/export.h"
#include "avo/vec3.h"

namespace avo::space {

/// Robot A, the robot that decides. Its body is a ball, and the air below the ball within
/// `downwash`.
struct Robot {
  Vec3 position = {};             ///< [p_A] m, the center of its ball
  Vec3 velocity = {};             ///< [v_A] m/s
  Vec3 preferred_velocity = {};   ///< [v_A^pref] m/s
  double radius = 0.5;            ///< [r_A] m, > 0
  double max_acceleration = 1.0;  ///< [a_A^max] m/s^2, > 0
  double max_speed = 2.0;         ///< [v_A^max] m/s, > 0
  /// [e_A] > 0: its limits along the vertical, as a part of those along the horizontal. Its
  /// accelerations lie in the ellipsoid a_x² + a_y² + (a_z/e)² <= a_max², and so do its velocities.
  double vertical = 1.0;
  double climb = std::numeric_limits<double>::infinity();  ///< m/s, > 0: the largest v_z
  double sink = std::numeric_limits<double>::infinity();   ///< m/s, > 0: the largest -v_z
  /// [w_A] m, >= 0: no robot may be in the vertical capsule of radius r_A + r_B that reaches so far
  /// below A
  double downwash = 0.0;
  /// > 0: in a pair, A does the part p_B/(p_A + p_B) of the avoidance of both
  double priority = 1.0;
  /// [b_A] m/s^2, > 0: the deceleration with which it surely brakes, straight, along the
  /// horizontal; unset: max_acceleration
  std::optional<double> max_braking = {};
  /// m, left to the place where it comes to rest, if it has such a goal
  double distance_to_goal = std::numeric_limits<double>::infinity();
};

/// Another robot B as A senses it. B decides at the same times, by the same rules.
struct Neighbor {
  Vec3 position = {};                      ///< [p_B] m
  Vec3 velocity = {};                      ///< [v_B] m/s
  double radius = 0.5;                     ///< [r_B] m, > 0
  double max_acceleration = 1.0;           ///< [a_B^max] m/s^2, > 0
  double vertical = 1.0;                   ///< [e_B] > 0, see Robot::vertical
  double downwash = 0.0;                   ///< [w_B] m, >= 0, see Robot::downwash
  double priority = 1.0;                   ///< > 0, see Robot::priority
  std::optional<double> max_braking = {};  ///< [b_B] m/s^2, > 0; unset: max_acceleration
  /// [d] whole steps, 0 to kMostAge: the time since it was last sensed. Its state has been
  /// extrapolated since then at constant velocity, see avo::Neighbor::age.
  int age = 0;
};

/// The robot as others sense it without errors.
AVO_API Neighbor neighbor_of(const Robot& robot);

}  // namespace avo::space
