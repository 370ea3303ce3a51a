// SPDX-License-Identifier: Apache-2.0
// The limits of robots with headings: of their wheels, or wings.
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

/// m/s, the reference of the relative tolerance of speeds where there is no limit.
double speed_scale(const CheckedRobot& robot);

/// Returns whether the robot can brake to rest; a robot that cannot arrives by passing its goal.
bool can_rest(const CheckedRobot& robot);

/// m/s^2, for the velocities alone.
double reach_of(const CheckedRobot& robot);

/// For a row with a heading, and a step with has_heading(): counts broken rules.
void judge_heading(const CheckedRobot& robot, const CheckedState& row, double time,
                   double tolerance, CheckReport& report);
void judge_kinematics(const RowStep& step, CheckReport& report);

}  // namespace avo::judge
