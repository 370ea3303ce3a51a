// SPDX-License-Identifier: Apache-2.0
// The axle of a differential drive, from row to row: the point that accelerates evenly tows it.
#pragma once
#include <array>
#include <cstddef>

#include "check/arc.h"

namespace avo::judge {

/// An axle `offset` behind the point q; its heading h turns at ω = n·q'/offset.
struct TowedAxle {
  static constexpr std::size_t kParts = 64;  // of the step
  Vec2 from;                                 // m, of q
  Vec2 velocity, acceleration;               // m/s, m/s^2, of q
  double offset = 0.0;                       // m
  double duration = 0.0;                     // s
  std::array<Vec2, kParts + 1> heading;      // unit, at the ends of the parts
};

/// The axle from one row, with the velocities of both rows.
TowedAxle towed_axle(const CheckedState& before, const CheckedState& now, double offset,
                     double duration);

/// The point `ahead` m ahead of the axle at the end of a part.
CourseKnot knot_on(const TowedAxle& axle, double ahead, std::size_t part);
/// m/s^4, an upper bound of the fourth derivative of that place.
double fourth_derivative(const TowedAxle& axle, double ahead);

/// The largest of both wheels' |speed|, m/s, and |acceleration|, m/s^2, within the step.
struct WheelPeaks {
  double speed = 0.0, acceleration = 0.0;
};
WheelPeaks wheel_peaks(const TowedAxle& axle, double track);

}  // namespace avo::judge
