// SPDX-License-Identifier: Apache-2.0
// What a step asks of a robot's ability to change its velocity.
#pragma once
#include "avo/check.h"

namespace avo::judge {

/// A change of velocity, m/s: how much of it slows the robot down, and how much is across its way.
struct Change {
  double slowing = 0.0;
  double across = 0.0;  ///< >= 0
};

/// What a robot can do to its velocity, m/s.
struct Ability {
  double changing = 0.0;  ///< in any direction
  double braking = 0.0;   ///< and, where that is more, against its velocity
};

/// m/s, more than ability.changing if and only if the change is no mixture of full braking and of
/// what that allows: of a disc, or of a square about the heading. It is the change's length, or its
/// longest side, where it touches these; else the support of the mixture, in the same measure.
double demand_of(const Change& change, const Ability& ability, bool square);

/// m/s^2, with which the robot brakes at most.
double braking_of(const CheckedRobot& robot);

/// s: from when on a step that ends at a row may have been decided. Rows may stand within the steps
/// of one with a clock of its own.
double longest_step(const CheckedRobot& robot, double duration);

/// |Δv| in the same sense, m/s, of a robot that accelerates evenly, `before` to `now` within the
/// step. a_max: m/s^2, in any direction.
double demand_of(const CheckedRobot& robot, double a_max, Vec2 before, Vec2 now, double duration);

}  // namespace avo::judge
