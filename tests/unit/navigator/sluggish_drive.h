// SPDX-License-Identifier: Apache-2.0
// The wheels of this differential drive follow commands with a lag, in steps and not below some
// speed. A controller beside the wheels turns velocities into wheels' speeds by drive_command().
#pragma once
#include <algorithm>
#include <cmath>
#include <deque>

#include "avo/execution.h"
#include "avo/vec.h"

namespace avo::test {

struct SluggishDrive {
  ExecutionModel model;  // what its controller knows
  DifferentialDrive drive;
  double lag = 0.0, dead_time = 0.0;  // s, the true ones
  Vec2 axle = {};
  double heading = 0.0;
  double speed = 0.0, turning = 0.0;  // m/s, rad/s
  Vec2 error = {};                    // m/s, of the velocity of the point ahead of the axle
  double time = 0.0;

  [[nodiscard]] Vec2 ahead() const { return {std::cos(heading), std::sin(heading)}; }
  [[nodiscard]] Vec2 position() const { return axle + drive.offset * ahead(); }
  [[nodiscard]] Vec2 velocity() const {
    return speed * ahead() + (drive.offset * turning) * perpendicular(ahead());
  }

  void tell(Vec2 command) { sent.push_back({time + dead_time, command}); }

  /// Motion of `duration`, of which `cycles` of the wheels' controller are a whole number.
  template <typename Look>
  void move(double duration, int cycles, const Look& look) {
    const double from = time;
    for (int k = 1; k <= cycles; ++k) {
      while (!sent.empty() && sent.front().from <= time + 1e-9) {
        acting = sent.front().command;
        sent.pop_front();
      }
      control();
      constexpr int kSubsteps = 4;
      for (int part = 0; part < kSubsteps; ++part) coast(duration / (cycles * kSubsteps));
      time = from + duration * k / cycles;
      look(double(k) / cycles);
    }
  }

 private:
  struct Sent {
    double from;  // s
    Vec2 command;
  };
  std::deque<Sent> sent;
  Vec2 acting = {};
  double told_speed = 0.0, told_turning = 0.0;

  [[nodiscard]] double executed(double wheel) const {
    const double q = model.quantum;
    const double in_steps = q > 0.0 ? q * std::round(wheel / q) : wheel;
    return std::abs(in_steps) < model.deadband ? 0.0 : in_steps;
  }
  void control() {
    Robot body;
    body.position = position(), body.velocity = velocity();
    body.model = drive, body.heading = heading;
    const DriveCommand command = drive_command(model, body, acting);
    const double across = 0.5 * drive.track * command.turning_rate;
    const double left = executed(command.speed - across);
    const double right = executed(command.speed + across);
    told_speed = 0.5 * (left + right), told_turning = (right - left) / drive.track;
  }
  // The axle turns evenly: the middle rule is exact to the third order.
  void coast(double duration) {
    const double left = lag > 0.0 ? std::exp(-duration / lag) : 0.0;
    const double e_ahead = dot(error, ahead()), e_across = cross(ahead(), error) / drive.offset;
    const double next_speed = told_speed + e_ahead + left * (speed - told_speed - e_ahead);
    const double next_turning =
        told_turning + e_across + left * (turning - told_turning - e_across);
    const auto gone = [&](double v, double target) {
      return lag > 0.0 ? duration * target + lag * (1.0 - left) * (v - target) : duration * target;
    };
    const double turned = gone(turning, told_turning + e_across);
    const double along = gone(speed, told_speed + e_ahead);
    const double middle = heading + 0.5 * turned;
    axle = axle + along * Vec2{std::cos(middle), std::sin(middle)};
    heading = std::remainder(heading + turned, 6.283185307179586);
    speed = next_speed, turning = next_turning;
  }
};

}  // namespace avo::test
