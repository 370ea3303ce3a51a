// SPDX-License-Identifier: Apache-2.0
// Robots of a fleet that cooperate: the others count on their share, and not on their brakes.
#include <gtest/gtest.h>
#include <vector>

#include "avo/assumptions.h"
#include "avo/check.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;
using test::robot_at;

RobotSetup cooperating(Vec2 position, Vec2 goal) {
  RobotSetup setup = robot_at(position, goal);
  setup.behavior = Behavior::cooperates;
  return setup;
}

Scenario facing() {
  Scenario scene;
  scene.robots = {robot_at({-6, 0}, {6, 0}), cooperating({6, 0}, {-6, 0})};
  scene.sensing_radius = 30.0;
  return scene;
}

TEST(Cooperating, is_sensed_as_such_by_whom_it_avoids) {
  Scenario scene = facing();
  Simulation simulation(scene, 1);
  const auto of_first = [](const Simulation& s) { return s.perceive({0}).neighbors.at(0); };
  EXPECT_EQ(of_first(simulation).behavior, Behavior::cooperates);
  EXPECT_EQ(of_first(simulation).max_deviation, 0.0);
  EXPECT_EQ(of_first(simulation).max_acceleration, 1.0) << "its share";
  EXPECT_EQ(simulation.perceive({1}).neighbors.at(0).behavior, Behavior::decides);
  EXPECT_FALSE(simulation.perceive({0}).among_movers);
  EXPECT_EQ(simulation.fleet().setup[1].behavior, Behavior::cooperates);
  scene.robots[1].avoids = {0};
  EXPECT_EQ(of_first(Simulation(scene, 1)).behavior, Behavior::moves_on);
  scene.sensing.dropped = 0.1;  // robots then sense by other code
  scene.robots[1].avoids = scene.robots[0].avoids;
  EXPECT_EQ(of_first(Simulation(scene, 1)).behavior, Behavior::cooperates);
}

// A robot that decides matters to the certificate from as far as both can brake. One that
// cooperates matters from as far as it comes until the other one rests, be it among the nearest or
// not.
TEST(Cooperating, counts_beyond_the_nearest) {
  Scenario scene = facing();
  scene.max_neighbors = 1;
  scene.robots[0].position = {-3.8, 0}, scene.robots[0].velocity = {2, 0};
  scene.robots[1].position = {3.8, 0}, scene.robots[1].velocity = {-2, 0};
  scene.robots.push_back(robot_at({-3.8, 3}, {-3.8, 3}));
  Simulation simulation(scene, 1);
  const Simulation::Perception seen = simulation.perceive({0});
  Detour detour = seen.detour;
  PlanWorkspace workspace;
  const Plan expected =
      simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
  simulation.step();
  EXPECT_EQ(simulation.fleet().velocity[0], expected.next_velocity);
  scene.robots[1].behavior = Behavior::decides;
  Simulation counted_on(scene, 1);
  counted_on.step();
  EXPECT_NE(counted_on.fleet().velocity[0], expected.next_velocity);
}

// It is seen from as far as a mover: it may come on until the other one rests.
TEST(Cooperating, has_to_be_seen_from_farther) {
  Scenario scene = facing();
  const double cooperates = sensing_need(scene)->range;
  scene.robots[1].behavior = Behavior::decides;
  EXPECT_GT(cooperates, sensing_need(scene)->range + 1.0);
}

TEST(Cooperating, both_do_their_share) {
  Simulation simulation(facing(), 1);
  double aside[2] = {0.0, 0.0};
  while (simulation.can_step_by(30.0)) {
    simulation.step();
    for (std::size_t k : {0U, 1U})
      aside[k] = std::max(aside[k], std::abs(simulation.fleet().position[k].y));
  }
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_GT(aside[0], 0.2);
  EXPECT_GT(aside[1], 0.2);
}

// All robots are sent to one place after the other. A robot that decides never touches one that
// decides, though others among them promise nothing.
TEST(Cooperating, those_who_decide_never_touch_each_other) {
  Random random(7);
  for (const bool noisy : {false, true}) {
    Scenario scene;
    scene.max_neighbors = 8;
    for (int k = 0; k < 24; ++k) {
      RobotSetup robot = robot_at({2.5 * (k % 6) - 6.0, 3.0 * (k / 6) - 4.0}, {});
      robot.max_acceleration = random.uniform(0.6, 2.0);
      if (k % 3 == 0) robot.behavior = Behavior::cooperates;
      scene.robots.push_back(robot);
    }
    if (noisy) scene.sensing.noise.position = 0.01;
    scene.sensing_radius = needed_sensing_radius(scene);
    Simulation simulation(scene, 1);
    std::vector<CheckedRobot> judged;
    for (const RobotSetup& robot : scene.robots)
      if (robot.behavior == Behavior::decides)
        judged.push_back({robot.radius, robot.max_acceleration, robot.max_speed});
    Check check(judged);
    std::vector<CheckedState> rows;
    const auto observe = [&] {
      rows.clear();
      for (std::size_t k = 0; k < 24; ++k)
        if (k % 3 != 0)
          rows.push_back({static_cast<std::int64_t>(rows.size()), simulation.fleet().position[k],
                          simulation.fleet().velocity[k]});
      check.add(simulation.time(), rows);
    };
    observe();
    for (int step = 0; step < 800; ++step) {
      if (step % 60 == 0) {
        const Vec2 rally = test::in_disc(random, 4.0);
        for (std::uint64_t k = 0; k < 24; ++k) simulation.set_goal({k}, rally);
      }
      simulation.step();
      observe();
    }
    EXPECT_EQ(check.report().overlaps.count, 0) << check.report().overlaps.worst;
    EXPECT_LT(*check.report().least_clearance, 0.1) << "it was tight";
    EXPECT_TRUE(check.report().safe());
  }
}

TEST(Cooperating, is_saved) {
  Simulation simulation(facing(), 1);
  for (int step = 0; step < 10; ++step) simulation.step();
  Simulation continued(simulation.save(), 1);
  EXPECT_EQ(continued.fleet().setup[1].behavior, Behavior::cooperates);
  EXPECT_EQ(continued.fleet().setup[0].behavior, Behavior::decides);
  for (int step = 0; step < 40; ++step) {
    simulation.step(), continued.step();
    ASSERT_EQ(simulation.state_hash(), continued.state_hash());
  }
}

// A robot that has failed, as the host says: the others leave it no share, and count on its
// velocity.
TEST(Cooperating, nobody_counts_on_one_that_moves_on) {
  Scenario scene = facing();
  scene.robots[0].position = {-9, 0}, scene.robots[0].goal = {9, 0};
  scene.robots[1] = robot_at({9, 0.1}, {-9, 0.1});
  Simulation simulation(scene, 1);
  RobotSetup failed = simulation.setup({1});
  failed.behavior = Behavior::moves_on;
  simulation.change_robot({1}, failed);
  const Neighbor seen = simulation.perceive({0}).neighbors.at(0);
  EXPECT_EQ(seen.behavior, Behavior::moves_on);
  EXPECT_GT(seen.likely_deviation, 0.0);
  EXPECT_EQ(simulation.perceive({1}).neighbors.at(0).behavior, Behavior::decides);
  EXPECT_TRUE(simulation.perceive({0}).among_movers);
  Simulation continued(simulation.save(), 1);
  EXPECT_EQ(continued.setup({1}).behavior, Behavior::moves_on);
  double nearest = 99.0;
  while (simulation.can_step_by(30.0)) {
    simulation.step();
    nearest =
        std::min(nearest, norm(simulation.fleet().position[0] - simulation.fleet().position[1]));
  }
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_GT(nearest, 1.0);
  // it could brake, and is not counted on for that
  scene.robots[1].behavior = Behavior::moves_on;
  scene.robots[0].velocity = {1.5, 0}, scene.robots[1].velocity = {-2, 0};
  scene.robots[1].position = {-4.4, 0};
  EXPECT_EQ(broken_assumptions(scene).start_count, 1);
  scene.robots[1].behavior = Behavior::decides;
  EXPECT_EQ(broken_assumptions(scene).start_count, 0);
}

TEST(Cooperating, other_behavior_is_refused) {
  Scenario scene = facing();
  scene.robots[1] = cooperating({6, 0}, {6, 0});
  scene.robots[0].model = Airplane{};
  scene.robots[0].max_speed = 2.0;
  EXPECT_EQ(refusal([&] { validate(scene); }),
            "robots.1.behavior: found cooperates, must be decides in a scene with airplanes, which "
            "cannot stop for it");
}

}  // namespace
}  // namespace avo
