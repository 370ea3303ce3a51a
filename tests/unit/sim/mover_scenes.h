// SPDX-License-Identifier: Apache-2.0
// Scenes of one robot among movers.
#pragma once
#include "avo/scenario.h"
#include "scenes.h"

namespace avo::test {

inline MovingObstacle mover(Vec2 position, Vec2 velocity, double radius) {
  MovingObstacle result;
  result.position = position, result.velocity = velocity, result.radius = radius;
  return result;
}

inline Scenario one_robot(Vec2 position, Vec2 goal, double time_step) {
  Scenario scene;
  scene.time_step = time_step;
  scene.sensing_radius = 60.0;
  scene.robots = {robot_at(position, goal)};
  scene.robots[0].radius = 0.4;
  return scene;
}

}  // namespace avo::test
