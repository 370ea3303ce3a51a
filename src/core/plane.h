// SPDX-License-Identifier: Apache-2.0
// Helpers for numbers and plane vectors that several layers use, and that are no part of the
// interface.
#pragma once
#include <cmath>
#include <limits>
#include <numbers>

#include "avo/vec.h"

namespace avo::inline core {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// a turned by the angle of a unit vector.
constexpr Vec2 turned(Vec2 a, Vec2 by) {
  return {a.x * by.x - a.y * by.y, a.x * by.y + a.y * by.x};
}
/// rad: the same direction in [-pi, pi].
inline double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}
/// The velocity after a step of at most `most` from v towards a target, m/s.
inline Vec2 approach(Vec2 velocity, Vec2 target, double most) {
  const Vec2 change = target - velocity;
  const double length = norm(change);
  return length > most ? velocity + (most / length) * change : target;
}
/// Returns whether a velocity counts as 0: the squares of slower ones have lost their digits, and
/// so has norm().
constexpr bool is_rest(Vec2 velocity) {
  return norm_squared(velocity) < std::numeric_limits<double>::min();
}
/// An upper bound of the length, at most sqrt(2) times it.
inline double length_1(Vec2 a) {
  return std::abs(a.x) + std::abs(a.y);
}

}  // namespace avo::inline core
