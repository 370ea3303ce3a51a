// SPDX-License-Identifier: Apache-2.0
// How a robot, its goal and a moving obstacle look in pictures of runs.
#pragma once
#include "avo/scenario.h"
#include "avo/vec.h"
#include "figures/canvas.h"

namespace avo::figures {

/// See RobotSetup.
struct Pose {
  Vec2 position;         ///< m
  double heading = 0.0;  ///< rad
};

/// `age` in [0, 1]: 1 is the newest, darkest one, 0 nearly white. Parked ones are gray.
void draw_robot(Canvas& canvas, const RobotSetup& setup, const Pose& pose, Color color, double age);
void draw_mover(Canvas& canvas, const Disc& disc, double age);
/// A cross; none of who is parked.
void draw_goal(Canvas& canvas, const RobotSetup& setup, Color color);

}  // namespace avo::figures
