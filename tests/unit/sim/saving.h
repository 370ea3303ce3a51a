// SPDX-License-Identifier: Apache-2.0
// The tests look at the saved states of these scenes.
#pragma once
#include <cstddef>
#include <vector>

#include "unit/sim/scenes.h"

namespace avo::test {

using Bytes = std::vector<std::byte>;

/// Each robot decides by a clock of its own, some of them more often.
inline Scenario with_clocks(Random& random, Scenario scene) {
  scene.motion = Motion::held;
  scene.clock = Clock::free;
  scene.longest_step = 0.2;
  for (RobotSetup& robot : scene.robots) {
    if (!is_parked(robot) && random.below(3) == 0)
      robot.time_step = random.below(2) == 0 ? 0.05 : 0.2;
  }
  return scene;
}

inline Scenario holonomic_scene(int robots) {
  Scenario scene = dense_scene(robots, Motion::held);
  for (RobotSetup& robot : scene.robots) robot.model = Holonomic{};
  return scene;
}

}  // namespace avo::test
