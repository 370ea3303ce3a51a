// SPDX-License-Identifier: Apache-2.0
// Fleets among walls.
#pragma once
#include <vector>

#include "unit/navigation/mazes.h"
#include "unit/sim/scenes.h"

namespace avo::test {

inline StaticObstacle pieces(const std::vector<Wall>& walls) {
  StaticObstacle obstacle;
  for (const Wall& wall : walls) obstacle.chains.push_back({{wall.a, wall.b}, false});
  return obstacle;
}

inline Vec2 cell_of_maze(int k) {
  return {1.5 + 3.0 * (k % 10), 1.5 + 3.0 * (k / 10)};
}

/// Up to four robots in each cell of a maze of 10 x 10, on their ways to others.
inline Scenario crowded_maze(int robots) {
  Scenario scene;
  scene.obstacles = {pieces(maze(10, 3.0, 4))};
  for (int k = 0; k < robots; ++k) {
    RobotSetup robot = robot_at(cell_of_maze((7 * k) % 100), cell_of_maze((31 * k + 5) % 100));
    const Vec2 shift{0.55 * (k / 100 % 2 == 0 ? -1 : 1), 0.55 * (k / 200 % 2 == 0 ? -1 : 1)};
    robot.position = robot.position + shift;
    robot.radius = k % 2 == 0 ? 0.3 : 0.25;
    scene.robots.push_back(robot);
  }
  return scene;
}

}  // namespace avo::test
