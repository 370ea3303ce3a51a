// SPDX-License-Identifier: Apache-2.0
// The axle of a differential drive, from row to row: it is towed by the point that accelerates
// evenly.
#pragma once
#include <array>
#include <cstddef>

#include "check/arc.h"

namespace avo::judge {

/// An axle `offset` behind the point q, whose heading h turns at ω = n·q'/offset.
struct TowedAxle {
  static constexpr std::size_t kParts = 64;  // of the step
  Vec2 from;                                 // m, of q
  Vec2 velocity, acceleration;               // m/s, m/s^2, of q
  double offset = 0.0;                       // m
  double duration = 0.0;                     // s
  std::array<Vec2, kParts + 1> heading;      // unit, where the parts end
};

/// From one row, at the velocities of both.
TowedAxle towed_axle(const CheckedState& before, const CheckedState& now, double offset,
                     double duration);

/// Of the axle, where a part ends.
Knot knot_on(const TowedAxle& axle, std::size_t part);
/// m/s^4, at least the fourth derivative of its place.
double fourth_derivative(const TowedAxle& axle);

/// The largest of both wheels' |speed|, m/s, and |acceleration|, m/s^2, within the step.
struct WheelPeaks {
  double speed = 0.0, acceleration = 0.0;
};
WheelPeaks wheel_peaks(const TowedAxle& axle, double track);

}  // namespace avo::judge
