// SPDX-License-Identifier: Apache-2.0
// Motion of robots with headings in closed form, for recordings.
#pragma once
#include <cmath>
#include <numbers>

#include "unit/check/recordings.h"

namespace avo::test {

inline Vec2 along(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// A row of what moves along its heading.
inline CheckedState pose(Vec2 position, double angle, double speed, std::int64_t robot = 0) {
  return {robot, position, speed * along(angle), CheckedHeading{angle, speed}};
}

/// Controls that are held, and what they make of a row after some time.
struct Held {
  double change = 0.0;     // m/s^2, of the speed
  double curvature = 0.0;  // 1/m
};

inline CheckedState driven(const CheckedState& from, const Held& held, double time) {
  const double speed = from.heading->speed, angle = from.heading->angle;
  const double way = speed * time + 0.5 * held.change * time * time;
  const double half = 0.5 * held.curvature * way;
  const double chord = std::abs(half) < 1e-9 ? way : way * std::sin(half) / half;
  const double next = std::remainder(angle + 2.0 * half, 2.0 * std::numbers::pi);
  return pose(from.position + chord * along(angle + half), next, speed + held.change * time,
              from.robot);
}

/// An axle `offset` behind a point of constant velocity, `off` rad from its heading at time 0.
struct Towed {
  Vec2 point, velocity;  // m, m/s, at time 0
  double off = 0.0, offset = 0.2;

  /// tan(φ/2) decays exponentially.
  [[nodiscard]] double angle(double time) const {
    const double ratio = std::tan(0.5 * off) * std::exp(-norm(velocity) * time / offset);
    return std::atan2(velocity.y, velocity.x) - 2.0 * std::atan(ratio);
  }
  [[nodiscard]] Vec2 axle(double time) const {
    return point + time * velocity - offset * along(angle(time));
  }
  [[nodiscard]] CheckedState row(double time) const {
    return {0, axle(time), velocity,
            CheckedHeading{angle(time), dot(along(angle(time)), velocity)}};
  }
};

}  // namespace avo::test
