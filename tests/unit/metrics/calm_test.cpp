// SPDX-License-Identifier: Apache-2.0
// Crowds of method avo do not shake (docs/smoothness.md), and would if they adopted v' at once.
#include <gtest/gtest.h>

#include "runs.h"

namespace avo {
namespace {

using test::robot_at;

Scenario at_once(Scenario scene) {
  scene.response_time = 0.0;
  return scene;
}

RobotSetup walker(Vec2 position, Vec2 goal) {
  RobotSetup robot = robot_at(position, goal);
  robot.preferred_speed = 1.5;
  return robot;
}

// One behind the other at equal speed, 2 m of air between them.
Scenario march() {
  Scenario scene;
  scene.robots = {walker({-20, 0}, {20, 0}), walker({-17, 0}, {23, 0})};
  return scene;
}

// Four blocks of 4 x 4 robots cross, and each block goes to the opposite side.
Scenario streams() {
  Scenario scene;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double x = 17.0 + 2.0 * column, y = -3.0 + 2.0 * row;
      for (const double side : {1.0, -1.0}) {
        scene.robots.push_back(walker({side * x, y}, {side * (x - 40.0), y}));
        scene.robots.push_back(walker({y, side * x}, {y, side * (x - 40.0)}));
      }
    }
  }
  return scene;
}

TEST(Calm, robots_one_behind_the_other) {
  const RunMetrics gentle = run(march(), 400).metrics;
  EXPECT_LE(*gentle.jerk, 0.6);
  EXPECT_LE(*gentle.reversals, 1.0);
  EXPECT_EQ(*gentle.turned_back, 0.0);
}

TEST(Calm, streams_that_cross) {
  const RunSummary gentle = run(streams(), 500);
  EXPECT_EQ(gentle.collision_pairs, 0);
  EXPECT_EQ(gentle.arrived, 64);
  EXPECT_LE(*gentle.metrics.turned_back, 0.003);
  EXPECT_LE(*gentle.metrics.jerk, 1.5);
  EXPECT_GT(*run(at_once(streams()), 450).metrics.turned_back, 0.05);
}

}  // namespace
}  // namespace avo
