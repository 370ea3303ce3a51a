// SPDX-License-Identifier: Apache-2.0
// Pairs that are first seen too late: round a corner, or with a sensing radius that is too short.
#include <gtest/gtest.h>
#include <optional>

#include "runs.h"

namespace avo {
namespace {

using test::robot_at;

// Two that go round the tip of a wall, each to where the other one comes from.
Scenario round_a_tip(bool occlusion) {
  Scenario scene;
  scene.robots = {robot_at({-0.8, -9.0}, {0.8, -9.0}), robot_at({0.8, -9.0}, {-0.8, -9.0})};
  scene.obstacles.push_back({{{{{0.0, -12.0}, {0.0, 0.0}}, false}}, 0.0});
  scene.sensing.occlusion = occlusion;
  return scene;
}

TEST(FirstSights, count_the_pair_that_meets_round_a_corner) {
  EXPECT_EQ(run(round_a_tip(true), 300).first_seen_too_late, 1);
  EXPECT_EQ(run(round_a_tip(false), 300).first_seen_too_late, 0);
}

// They pass a wall on both sides, and see each other from afar when they come out.
TEST(FirstSights, do_not_count_who_comes_into_sight_far_away) {
  Scenario scene;
  scene.robots = {robot_at({-9.0, -0.7}, {9.0, -0.7}), robot_at({9.0, 4.0}, {-9.0, 4.0})};
  scene.obstacles.push_back({{{{{-3.0, 0.0}, {3.0, 0.0}}, false}}, 0.0});
  scene.sensing.occlusion = true;
  EXPECT_EQ(run(scene, 120).first_seen_too_late, 0);
}

TEST(FirstSights, count_who_comes_within_a_sensing_radius_that_is_too_short) {
  Scenario scene;
  scene.robots = {cruising({-6.0, 0.0}, {6.0, 0.0}), cruising({6.0, 0.0}, {-6.0, 0.0}),
                  cruising({-6.0, 30.0}, {6.0, 30.0})};
  scene.moving_obstacles = {{{8.0, 30.0}, {-2.0, 0.0}, {}, 0.5}};
  scene.sensing_radius = 4.5;  // both robots would need 5.4 m
  scene.allow_broken_assumptions = true;
  EXPECT_EQ(run(scene, 60).first_seen_too_late, 2);
  scene.sensing_radius = 15.0;
  EXPECT_EQ(run(scene, 60).first_seen_too_late, 0);
}

TEST(FirstSights, are_not_those_of_the_start_or_of_robots_that_are_added) {
  Scenario scene;
  scene.robots = {cruising({-1.0, 0.0}, {6.0, 0.0}), cruising({1.0, 0.0}, {-6.0, 0.0})};
  scene.sensing_radius = 5.0;
  scene.allow_broken_assumptions = true;
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  const RobotId added = simulation.add_robot(robot_at({-1.5, 0.5}, {0.0, 9.0}));
  simulation.step();
  metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().first_seen_too_late, 0);
  simulation.remove_robot(added);
  simulation.step();
  metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().first_seen_too_late, 0);
}

TEST(FirstSights, are_not_looked_for_without_a_certificate) {
  Scenario scene = round_a_tip(true);
  scene.certificate = Certificate::none;
  EXPECT_EQ(run(scene, 3).first_seen_too_late, std::nullopt);
}

// Missed now and then, they are carried on.
TEST(FirstSights, are_none_where_measurements_fail_now_and_then) {
  Scenario scene;
  scene.robots = {cruising({-9.0, 0.0}, {9.0, 0.2}), cruising({9.0, 0.0}, {-9.0, 0.0})};
  scene.sensing.dropped = 0.3;
  EXPECT_EQ(run(scene, 120).first_seen_too_late, 0);
  scene.sensing.dropped = 0.97;  // forgotten, and seen again too late
  EXPECT_EQ(run(scene, 120).first_seen_too_late, 1);
}

}  // namespace
}  // namespace avo
