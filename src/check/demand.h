// SPDX-License-Identifier: Apache-2.0
// The demand of a step on a robot's ability to change its velocity.
#pragma once
#include "avo/check.h"

namespace avo::judge {

/// A change of velocity, m/s: the part that slows the robot down, and the part across its velocity.
struct Change {
  double slowing = 0.0;
  double across = 0.0;  ///< >= 0
};

/// The possible change of a robot's velocity, m/s.
struct Agility {
  double changing = 0.0;  ///< in any direction
  double braking = 0.0;   ///< and against its velocity, where that is more
};

/// m/s. It is more than ability.changing if and only if the change is no mixture of full braking
/// and a change within ability.changing. The latter is a disc, or a square about the heading. The
/// value is the change's length, or its longest side, where it touches these; otherwise the support
/// of the mixture, in the same measure.
double demand_of(const Change& change, const Agility& ability, bool square);

/// m/s^2, the robot's largest deceleration.
double braking_of(const CheckedRobot& robot);

/// s: the longest time before a row at which the step that ends there may have been decided. Rows
/// may exist within the steps of a robot with its own clock.
double longest_step(const CheckedRobot& robot, double duration);

/// |Δv| with the same meaning, m/s, for a robot that accelerates evenly, `before` to `now` within
/// the step. a_max: m/s^2, in any direction.
double demand_of(const CheckedRobot& robot, double a_max, Vec2 before, Vec2 now, double duration);

}  // namespace avo::judge
