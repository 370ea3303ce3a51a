// SPDX-License-Identifier: Apache-2.0
// A quadrotor in flight, in steps of 1 ms: the thrust axis turns with two poles behind what the
// autopilot wants, the motors lag, thrust and tilt are clipped, and gusts push. It shares nothing
// with the library but the set points.
#pragma once
#include "avo/space/quadrotor.h"
#include "unit/space/draws.h"

namespace avo::space::tests {

inline constexpr double kGravity = 9.80665;  // m/s^2

/// How an autopilot chooses thrust, of the force F that it wants, and the vehicle's axis b.
enum class ThrustLaw {
  projected,  ///< F·b
  whole,      ///< |F|, as PX4
  vertical,   ///< F_z/b_z: height is held while the vehicle turns
};

struct Airframe {
  Quadrotor quadrotor;
  ThrustLaw law = ThrustLaw::whole;
  double gust = 0.5;          ///< m/s^2, at most
  double largest_turn = 2.2;  ///< the largest angular acceleration, of rad/pole²
  double feedback = 0.7;      ///< the two poles of the position's feedback, of 1/T
};

class Flight {
 public:
  static constexpr double kTick = 0.001;  // s

  Flight(const Airframe& airframe, Vec3 position, std::uint64_t seed);
  /// Flies for a tick.
  void tick(const SetPoint& set_point);
  Vec3 position() const { return position_; }
  Vec3 velocity() const { return velocity_; }

 private:
  Vec3 wanted_force(const SetPoint& set_point) const;
  void turn(Vec3 direction);
  double wanted_thrust(Vec3 force) const;

  Airframe airframe_;
  double pole_;          // s, of the attitude
  double least_, most_;  // m/s^2, of thrust
  Draws draws_;
  Vec3 position_, velocity_;
  Vec3 axis_ = {0.0, 0.0, 1.0};  // of thrust
  Vec3 turning_, torque_;        // rad/s, rad/s^2
  double thrust_;                // m/s^2
  Vec3 gust_;
  int ticks_ = 0;
};

}  // namespace avo::space::tests
