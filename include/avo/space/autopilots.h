// SPDX-License-Identifier: Apache-2.0
// Set points of quadrotors in the frames, units and types of two autopilots (docs/space.md,
// "Quadrotors"). In the scene x points east, y north and z up.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "avo/export.h"
#include "avo/space/quadrotor.h"

namespace avo::space {

/// Of a value that the autopilot does not use.
inline constexpr float kNotControlled = std::numeric_limits<float>::quiet_NaN();

/// The message TrajectorySetpoint of PX4, in its local frame: north, east, down.
struct Px4SetPoint {
  std::uint64_t timestamp = 0;  ///< µs
  std::array<float, 3> position = {};
  std::array<float, 3> velocity = {};
  std::array<float, 3> acceleration = {};  ///< m/s^2, without gravity
  std::array<float, 3> jerk = {kNotControlled, kNotControlled, kNotControlled};
  float yaw = kNotControlled;
  float yawspeed = kNotControlled;
};
/// time: s, >= 0, of the autopilot's clock. Throws Error on other times, and on values that are not
/// finite or beyond 1e12.
AVO_API Px4SetPoint px4_set_point(const SetPoint& point, double time);

/// What send_full_state_setpoint() of the Crazyflie's Python library takes, in the scene's frame.
/// The attitude is level and the rates are 0: the vehicle's controller adds the tilt that the
/// acceleration needs.
struct CrazyflieSetPoint {
  std::array<float, 3> position = {};                           ///< m
  std::array<float, 3> velocity = {};                           ///< m/s
  std::array<float, 3> acceleration = {};                       ///< m/s^2, without gravity
  std::array<float, 4> orientation = {0.0F, 0.0F, 0.0F, 1.0F};  ///< quaternion x, y, z, w
  float roll_rate = 0.0F, pitch_rate = 0.0F, yaw_rate = 0.0F;   ///< degrees/s
};
/// A packet has thousandths in 16 bits. Throws Error on values beyond 32.767 m, m/s or m/s^2.
AVO_API CrazyflieSetPoint crazyflie_set_point(const SetPoint& point);

}  // namespace avo::space
