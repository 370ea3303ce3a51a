// SPDX-License-Identifier: Apache-2.0
// A differential drive by its two wheels, integrated finely, as a judge of src/robots/drive.cpp.
// The axle has a place, a heading, a speed and a turning rate; no formula is about the point ahead.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "avo/model.h"

namespace avo::test {

inline double angle_between(double a, double b) {
  return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
}

struct AxleState {
  double x = 0.0, y = 0.0, heading = 0.0;
  double speed = 0.0, turning = 0.0;  // m/s, rad/s
};

/// Returns the state of an axle with a point ahead that moves by `velocity`.
inline AxleState axle_of(const DifferentialDrive& drive, Vec2 center, Vec2 velocity,
                         double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  return {center.x - drive.offset * c, center.y - drive.offset * s, heading,
          c * velocity.x + s * velocity.y, (c * velocity.y - s * velocity.x) / drive.offset};
}
inline Vec2 center_of(const DifferentialDrive& drive, const AxleState& axle) {
  return {axle.x + drive.offset * std::cos(axle.heading),
          axle.y + drive.offset * std::sin(axle.heading)};
}
inline Vec2 center_velocity(const DifferentialDrive& drive, const AxleState& axle) {
  const double c = std::cos(axle.heading), s = std::sin(axle.heading);
  const double across = drive.offset * axle.turning;
  return {axle.speed * c - across * s, axle.speed * s + across * c};
}

/// The largest values of both wheels so far, m/s and m/s².
struct WheelUse {
  double speed = 0.0, acceleration = 0.0;
  void take(const WheelUse& other) {
    speed = std::max(speed, other.speed), acceleration = std::max(acceleration, other.acceleration);
  }
};

/// The derivatives of the axle's speed and turning with which its point ahead accelerates by a,
/// found by solving for them.
struct AxleControls {
  double speed, turning;
};
inline AxleControls controls_for(const DifferentialDrive& drive, const AxleState& axle, Vec2 a) {
  const double c = std::cos(axle.heading), s = std::sin(axle.heading);
  // (v h + L ω n)' = (v' - L ω²) h + (v ω + L ω') n
  return {c * a.x + s * a.y + drive.offset * axle.turning * axle.turning,
          (c * a.y - s * a.x - axle.speed * axle.turning) / drive.offset};
}

inline WheelUse use_of(const DifferentialDrive& drive, const AxleState& axle, Vec2 a) {
  const AxleControls u = controls_for(drive, axle, a);
  const double half = 0.5 * drive.track;
  return {std::max(std::abs(axle.speed - half * axle.turning),
                   std::abs(axle.speed + half * axle.turning)),
          std::max(std::abs(u.speed - half * u.turning), std::abs(u.speed + half * u.turning))};
}

/// Runge-Kutta of order four over `time` with the point ahead accelerated by a. Returns the use of
/// the wheels at the ends of all substeps.
inline WheelUse integrate(const DifferentialDrive& drive, AxleState& axle, Vec2 a, double time,
                          int substeps) {
  const auto rate = [&](const AxleState& s) {
    const AxleControls u = controls_for(drive, s, a);
    return AxleState{s.speed * std::cos(s.heading), s.speed * std::sin(s.heading), s.turning,
                     u.speed, u.turning};
  };
  const auto moved = [](const AxleState& s, double h, const AxleState& d) {
    return AxleState{s.x + h * d.x, s.y + h * d.y, s.heading + h * d.heading, s.speed + h * d.speed,
                     s.turning + h * d.turning};
  };
  const double h = time / substeps;
  WheelUse use = use_of(drive, axle, a);
  for (int k = 0; k < substeps; ++k) {
    const AxleState d1 = rate(axle), d2 = rate(moved(axle, h / 2, d1)),
                    d3 = rate(moved(axle, h / 2, d2)), d4 = rate(moved(axle, h, d3));
    axle = moved(moved(moved(moved(axle, h / 6, d1), h / 3, d2), h / 3, d3), h / 6, d4);
    use.take(use_of(drive, axle, a));
  }
  return use;
}

}  // namespace avo::test
