// SPDX-License-Identifier: Apache-2.0
// What a robot knows of itself and senses of the others (paper §IV-D). SI units.
#pragma once
#include <limits>

#include "avo/vec.h"

namespace avo {

/// Robot A, the one that decides.
struct Robot {
  Vec2 position = {};             ///< [p_A] m
  Vec2 velocity = {};             ///< [v_A] m/s
  Vec2 preferred_velocity = {};   ///< [v_A^pref] m/s
  double radius = 0.5;            ///< [r_A] m, > 0
  double max_acceleration = 1.0;  ///< [a_A^max] m/s^2, > 0
  double max_speed = 2.0;         ///< [v_A^max] m/s, > 0
  /// m left to where it comes to rest, where it has such a goal; method avo then makes no detours
  /// on the last of it.
  double distance_to_goal = std::numeric_limits<double>::infinity();
};

/// Another robot B as A senses it, or a moving obstacle that does not decide.
struct Neighbor {
  Vec2 position = {};             ///< [p_B] m
  Vec2 velocity = {};             ///< [v_B] m/s
  double radius = 0.5;            ///< [r_B] m, > 0
  double max_acceleration = 1.0;  ///< [a_B^max] m/s^2; 0: B does not decide, A's share is 1
  Vec2 acceleration = {};         ///< [a_B] m/s^2, observed; read only if max_acceleration is 0
};

}  // namespace avo
