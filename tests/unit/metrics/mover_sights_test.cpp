// SPDX-License-Identifier: Apache-2.0
// Hits of robots that had an evasive maneuver when they came to sense the moving obstacle.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>

#include "runs.h"
#include "unit/sim/mover_scenes.h"

namespace avo {
namespace {

using test::mover;
using test::Random;
using test::robot_at;

// The straight courses of the moving obstacles pass near the course of the robot.
Scenario among_movers(std::uint64_t seed) {
  Random random(seed);
  Scenario scene;
  scene.sensing_radius = 60.0;
  const bool rests = seed % 2 == 0;
  scene.robots = {rests ? robot_at({0, 0}, {0, 0}) : robot_at({-8, 0}, {8, 0})};
  for (int k = 0; k < 3; ++k) {
    const Vec2 along = random.direction(), velocity = random.uniform(0.5, 3.0) * along;
    const Vec2 meets{rests ? random.uniform(-0.5, 0.5) : random.uniform(-5.0, 5.0),
                     random.uniform(-0.5, 0.5)};
    const Vec2 from = meets - random.uniform(4.0, 12.0) * velocity;
    if (norm(from - scene.robots[0].position) > 5.0)
      scene.moving_obstacles.push_back(mover(from, velocity, random.uniform(0.3, 1.0)));
  }
  return scene;
}

TEST(MoverSights, nobody_alone_is_hit_who_had_an_evasion) {
  int with_way_out = 0;
  PlanWorkspace workspace;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Scenario scene = among_movers(seed);
    if (scene.moving_obstacles.empty()) continue;
    Simulation simulation(scene, 1);
    const auto seen = simulation.perceive({0});
    with_way_out +=
        simulation.planner().has_evasive_maneuver(seen.robot, seen.neighbors, workspace) ? 1 : 0;
    EXPECT_EQ(run(scene, 200).mover_collisions_evadable, 0) << seed;
  }
  EXPECT_GT(with_way_out, 50);
}

// A robot is in the midst of other robots that hardly move. Its evasive maneuver leads through the
// other robots, because courses do not look at other robots that decide.
Scenario walled_in(double speed) {
  Scenario scene;
  scene.sensing_radius = 30.0;
  scene.robots = {robot_at({0, 0}, {0, 0})};
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3.0;
    RobotSetup slow = robot_at(1.02 * Vec2{std::cos(angle), std::sin(angle)}, {});
    slow.goal = slow.position;
    slow.max_speed = slow.preferred_speed = 0.001;
    scene.robots.push_back(slow);
  }
  scene.moving_obstacles = {mover({-8.0 * speed, 0}, {speed, 0}, 0.3)};
  return scene;
}

TEST(MoverSights, count_who_had_an_evasion_and_was_hit) {
  const RunSummary summary = run(walled_in(1.0), 120);
  EXPECT_GE(summary.mover_collisions, 2);
  EXPECT_EQ(summary.mover_collisions_evadable, 1) << "the slow ones had no evasive maneuver";
  Scenario alone = walled_in(1.0);
  alone.robots.resize(1);
  EXPECT_EQ(run(alone, 120).mover_collisions, 0) << "so it was evadable";
}

TEST(MoverSights, do_not_count_whom_nobody_could_evade) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0})};
  scene.moving_obstacles = {mover({-30, 0}, {8, 0}, 1.0)};
  scene.allow_broken_assumptions = true;
  scene.sensing_radius = 60.0;
  EXPECT_EQ(run(scene, 80).mover_collisions, 0);
  scene.sensing_radius = 5.0;  // 0.4 s before contact
  const RunSummary late = run(scene, 80);
  EXPECT_EQ(late.mover_collisions, 1);
  EXPECT_EQ(late.mover_collisions_evadable, 0);
}

// On its path it has gone out of sight, and comes again where the robot cannot evade it any more:
// what counts is the last time.
TEST(MoverSights, are_those_of_the_last_time) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0})};
  scene.robots[0].max_speed = scene.robots[0].preferred_speed = 0.02;
  scene.allow_broken_assumptions = true;
  scene.sensing_radius = 6.0;
  MovingObstacle walker = mover({0, 5}, {0, 0}, 0.3);
  walker.max_deviation = 4.0, walker.max_speed = 4.0;
  walker.path = {{0, 20}, {0, -20}};
  scene.moving_obstacles = {walker};
  const RunSummary summary = run(scene, 200);
  EXPECT_EQ(summary.mover_collisions, 1);
  EXPECT_EQ(summary.mover_collisions_evadable, 0);
}

// A robot that keeps a certificate counts, whatever the method of the scene is.
TEST(MoverSights, are_of_robots_that_have_a_method_of_their_own) {
  Scenario scene = among_movers(2);
  scene.method = Method::orca;
  EXPECT_EQ(run(scene, 2).mover_collisions_evadable, std::nullopt);
  scene.robots[0].method = Method::avo;
  EXPECT_EQ(run(scene, 2).mover_collisions_evadable, 0);
}

TEST(MoverSights, say_nothing_without_a_certificate) {
  Scenario scene = walled_in(1.0);
  scene.certificate = Certificate::none;
  EXPECT_EQ(run(scene, 2).mover_collisions_evadable, std::nullopt);
  scene = walled_in(1.0);
  scene.moving_obstacles.clear();
  EXPECT_EQ(run(scene, 2).mover_collisions_evadable, 0);
}

}  // namespace
}  // namespace avo
