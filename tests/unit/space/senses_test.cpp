// SPDX-License-Identifier: Apache-2.0
// What robots of space sense: within what they declare, and enough to keep from contact.
#include "space/senses.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/space/metrics.h"
#include "avo/space/simulation.h"
#include "space/own_space.h"
#include "support/refusal.h"
#include "unit/space/draws.h"
#include "unit/space/runs.h"

namespace avo::space::tests {
namespace {

using test::refusal;

Scenario crossing(int count, std::uint64_t seed) {
  Scenario scene;
  scene.seed = seed;
  scene.duration = 60.0;
  Draws draws(seed);
  while (scene.robots.size() < static_cast<std::size_t>(count)) {
    RobotSetup robot;
    robot.position = 7.0 * draws.direction();
    const auto clear = [&](const RobotSetup& other) {
      return norm(other.position - robot.position) > 1.2;
    };
    if (!std::all_of(scene.robots.begin(), scene.robots.end(), clear)) continue;
    robot.goal = -robot.position;
    scene.robots.push_back(robot);
  }
  return scene;
}

SensingModel all_errors() {
  SensingModel model;
  model.noise = {.position = 0.02, .velocity = 0.04};
  model.delay = 1;
  model.dropped = 0.1;
  return model;
}

TEST(SpaceSenses, nobody_touches_and_all_arrive_with_noise_delay_and_missed_measurements) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Scenario scene = crossing(24, seed);
    scene.sensing = all_errors();
    const RunSummary summary = summary_of(scene, RunUntil::all_arrive);
    EXPECT_EQ(summary.collision_pairs, 0) << seed;
    EXPECT_EQ(summary.arrived, summary.robots) << seed;
  }
}

TEST(SpaceSenses, nobody_is_in_a_downwash_in_spite_of_errors) {
  Scenario scene = crossing(14, 4);
  for (RobotSetup& robot : scene.robots) {
    robot.position = 1.4 * robot.position, robot.goal = 1.4 * robot.goal;
    robot.radius = 0.4, robot.downwash = 1.0;
  }
  scene.sensing = all_errors();
  const RunSummary summary = summary_of(scene, RunUntil::all_arrive);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.arrived, summary.robots);
}

TEST(SpaceSenses, errors_that_are_not_declared_cost_contacts) {
  std::int64_t touched = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    Scenario scene = crossing(30, seed);
    scene.sensing = all_errors();
    scene.sensing.delay = 4;
    scene.sensing_error = SensingError{};
    touched += summary_of(scene, RunUntil::all_arrive).collision_pairs;
  }
  EXPECT_GT(touched, 0);
}

TEST(SpaceSenses, are_the_same_for_any_number_of_threads) {
  Scenario scene = crossing(80, 5);
  for (RobotSetup& robot : scene.robots) robot.radius = 0.3;
  scene.sensing = all_errors();
  Simulation one(scene, 1), four(scene, 4);
  for (int step = 0; step < 40; ++step) one.step(), four.step();
  EXPECT_EQ(one.state_hash(), four.state_hash());
}

TEST(SpaceSenses, exact_ones_leave_every_bit) {
  const Scenario exact = crossing(20, 6);
  Scenario declared = exact;
  declared.sensing_error = SensingError{};
  Simulation a(exact), b(declared);
  for (int step = 0; step < 60; ++step) a.step(), b.step();
  EXPECT_EQ(a.state_hash(), b.state_hash());
}

// Robots that change their velocity as fast as they can are measured within what is declared, with
// the addition of their age; and nearly as far off as that.
TEST(SpaceSenses, errors_stay_within_their_bounds_and_nearly_reach_them) {
  Scenario scene;
  scene.sensing.noise = {
      .position = 0.1, .velocity = 0.2, .distribution = NoiseDistribution::uniform};
  scene.sensing.delay = 3;
  scene.sensing.dropped = 0.5;
  scene.sensing_radius = 1e4;
  scene.robots.resize(2);
  scene.robots[1].vertical = 2.0;
  scene.robots[1].max_speed = 50.0;
  const SensingError declared = declared_error(scene);
  Senses senses = senses_of(scene);
  std::vector<Robot> robots{robot_of(scene.robots[0]), robot_of(scene.robots[1])};
  const double h = scene.time_step, change = top_acceleration(robots[1]);
  double nearest_position = 0.0, nearest_velocity = 0.0;
  int oldest = 0, unseen = 0;
  for (int step = 0; step < 20000; ++step) {
    senses.note(robots, {}, step);
    const auto seen = Observer(senses, 0, {}, {}).look_at(1, robots[1]);
    const double sign = step / 40 % 2 == 0 ? 1.0 : -1.0;
    const Vec3 next = robots[1].velocity + Vec3{0.0, 0.0, sign * 2.0 * h};
    const Robot now = robots[1];
    robots[1].position = now.position + 0.5 * h * (now.velocity + next);
    robots[1].velocity = next;
    if (!seen) {
      ++unseen;
      continue;
    }
    const double time = seen->age * h;
    const double most_velocity = declared.velocity + change * time;
    const double most_position =
        declared.position + time * declared.velocity + 0.5 * change * time * time;
    const double off_position = norm(seen->position - now.position);
    const double off_velocity = norm(seen->velocity - now.velocity);
    ASSERT_LE(off_position, most_position);
    ASSERT_LE(off_velocity, most_velocity);
    nearest_position = std::max(nearest_position, off_position / most_position);
    nearest_velocity = std::max(nearest_velocity, off_velocity / most_velocity);
    oldest = std::max(oldest, seen->age);
  }
  EXPECT_GT(nearest_position, 0.8);
  EXPECT_GT(nearest_velocity, 0.8);
  EXPECT_EQ(oldest, kMostCarried);
  EXPECT_NEAR(unseen, 20000.0 / 2048.0, 30.0);
}

TEST(SpaceSenses, a_box_between_two_centers_hides) {
  Scenario scene;
  scene.sensing.occlusion = true;
  scene.robots.resize(3);
  scene.robots[1].position = {4, 0, 0}, scene.robots[2].position = {0, 0, 4};
  scene.boxes = {{{1.9, -1, -1}, {2.1, 1, 1}, 0.0, 0.0}};
  Senses senses = senses_of(scene);
  std::vector<Robot> robots;
  for (const RobotSetup& robot : scene.robots) robots.push_back(robot_of(robot));
  senses.note(robots, {}, 0);
  const Solids solids(scene.boxes);
  const Observer observer(senses, 0, scene.boxes, solids);
  EXPECT_FALSE(observer.look_at(1, robots[1]));
  EXPECT_TRUE(observer.look_at(2, robots[2]));
}

// An age of d steps counts as a declared error of what the neighbor may have done since.
TEST(SpaceSenses, an_age_counts_as_a_declared_error) {
  Draws draws(7);
  int refused = 0, differs = 0, beyond = 0;
  PlanWorkspace workspace;
  for (int k = 0; k < 4000; ++k) {
    Robot robot;
    robot.velocity = draws.within(1.5);
    Neighbor other;
    other.position = draws.between(1.2, 4.0) * draws.direction();
    other.velocity = draws.within(1.5);
    other.vertical = k % 2 == 0 ? 1.0 : 0.5;
    const int age = 1 + draws.below(4);
    PlannerOptions exact{.method = Method::avo};
    PlannerOptions declared = exact;
    const double time = age * exact.time_step;
    declared.sensing_error = {0.5 * time * time, time};
    Neighbor aged = other;
    aged.age = age;
    const Vec3 next = robot.velocity + draws.within(0.1);
    const std::vector<Neighbor> now{other}, before{aged};
    const bool by_age = Planner(exact).is_admitted(robot, before, workspace, next);
    const bool by_error = Planner(declared).is_admitted(robot, now, workspace, next);
    const bool without = Planner(exact).is_admitted(robot, now, workspace, next);
    if (!by_age) ++refused;
    if (by_age != by_error) ++differs;
    if (by_age != without) ++beyond;
  }
  EXPECT_EQ(differs, 0);
  EXPECT_GT(refused, 100);
  EXPECT_GT(beyond, 100);
}

TEST(SpaceSenses, out_of_range_are_refused) {
  Scenario scene = crossing(2, 1);
  scene.sensing.localization.position = -0.1;
  EXPECT_EQ(refusal([&] { validate(scene); }),
            "sensing.localization.position: found -0.1, must be >= 0 m");
  scene = crossing(2, 1);
  scene.sensing.delay = 101;
  EXPECT_EQ(refusal([&] { validate(scene); }), "sensing.delay: found 101, must be <= 100 steps");
}

}  // namespace
}  // namespace avo::space::tests
