// SPDX-License-Identifier: Apache-2.0
// The limits of robots with headings: of what their wheels, or wings, can do.
#pragma once
#include "avo/check.h"

namespace avo::judge {

/// One robot from row to row.
struct RowStep {
  const CheckedRobot& robot;
  const CheckedState &before, &now;
  double from = 0.0, duration = 0.0;  // s
  double time_rounding = 0.0;         // s, of the duration
  double tolerance = 0.0;             // relative
};

/// m/s, of which the relative tolerance of speeds is a part where there is no limit.
double speed_scale(const CheckedRobot& robot);

/// m/s^2, of the velocities alone.
double reach_of(const CheckedRobot& robot);

/// A row with a heading, and a step of which has_heading() holds: counts what is broken.
void judge_heading(const CheckedRobot& robot, const CheckedState& row, double time,
                   double tolerance, CheckReport& report);
void judge_kinematics(const RowStep& step, CheckReport& report);

}  // namespace avo::judge
