// SPDX-License-Identifier: Apache-2.0
// How far the heading of a differential drive turns while it brakes, and within a step
// (docs/certificate/footprints.md, "Drives").
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/drive.h"

namespace avo::inline robots {

// dφ/ds = -sin φ/L on the straight path of q: the heading turns towards the velocity, and not past
// it.
BrakingPose turn_while_braking(const DifferentialDrive& drive, Vec2 velocity, Vec2 heading,
                               double length) {
  if (velocity == Vec2{}) return {heading, 0.0};
  const double off = elementary::atan2(cross(heading, velocity), dot(heading, velocity));
  const double half = 0.5 * std::min(std::abs(off), length / drive.offset);
  return {turned(heading, elementary::direction(std::copysign(half, off))), half};
}

// With σ = L ω, |σ| is at most the speed of q, and grows by a Δt + |σ| V Δt/L at most. The turn is
// within Δt²/8 of the largest |ω'| of an even one, and L |ω'| <= a + V |ω|.
BrakingPose turn_within(const DifferentialDrive& drive, const MotionState& from,
                        const MotionState& to, double time_step) {
  constexpr double kMost = 3.0;  // rad: a drive that may turn farther may have any heading
  const Vec2 heading = ahead_of(from.heading);
  const double gained = norm(to.velocity - from.velocity);
  const double top = std::max(norm(from.velocity), norm(to.velocity));
  const double most_turn = time_step * top / drive.offset;
  if (!(most_turn < kMost)) return {heading, std::numbers::pi};
  const double start = std::abs(cross(heading, from.velocity));
  const double sigma = most_turn < 1.0 ? std::min(top, (start + gained) / (1.0 - most_turn)) : top;
  const double change = (gained / time_step + top * sigma / drive.offset) / drive.offset;
  const double turn = wrapped(to.heading - from.heading);
  return {turned(heading, elementary::direction(0.5 * turn)),
          0.5 * std::abs(turn) + 0.125 * time_step * time_step * change};
}

}  // namespace avo::inline robots
