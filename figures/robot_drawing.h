// SPDX-License-Identifier: Apache-2.0
// Draws a robot, its goal and a moving obstacle in pictures of runs.
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

/// `age` in [0, 1]: 1 is the newest and darkest, 0 is nearly white. Parked robots are gray.
void draw_robot(Canvas& canvas, const RobotSetup& setup, const Pose& pose, Color color, double age);
void draw_mover(Canvas& canvas, const Disc& disc, double age);
/// Draws a cross; a parked robot gets none.
void draw_goal(Canvas& canvas, const RobotSetup& setup, Color color);

}  // namespace avo::figures
