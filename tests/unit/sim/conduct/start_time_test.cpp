// SPDX-License-Identifier: Apache-2.0
// Robots that start later stand where they are until then, and hinder no other robot by any rule.
#include <gtest/gtest.h>
#include <vector>

#include "avo/events.h"
#include "avo/explanation.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/navigation/buildings.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::refusal;
using test::robot_at;

RobotSetup starting_at(double time, Vec2 position, Vec2 goal) {
  RobotSetup robot = robot_at(position, goal);
  robot.start_time = time;
  return robot;
}

Scenario scene_of(std::vector<RobotSetup> robots) {
  Scenario scene;
  scene.sensing_radius = 30.0;
  scene.robots = std::move(robots);
  return scene;
}

void run_until(Simulation& simulation, double time) {
  while (simulation.can_step_by(time)) simulation.step();
}

// The same motion, so many steps later.
TEST(StartTime, is_when_a_robot_sets_out) {
  for (const double time : {2.0, 4.95, 5.0}) {
    const int steps = time == 2.0 ? 20 : 50;
    Simulation at_once(scene_of({robot_at({1, 2}, {9, 5})}), 1);
    Simulation later(scene_of({starting_at(time, {1, 2}, {9, 5})}), 1);
    for (int k = 0; k < steps; ++k) {
      later.step();
      EXPECT_EQ(later.fleet().position[0], (Vec2{1, 2}));
      EXPECT_EQ(later.fleet().velocity[0], Vec2{});
    }
    for (int k = 0; k < 150; ++k) {
      at_once.step(), later.step();
      ASSERT_EQ(later.fleet().position[0], at_once.fleet().position[0]) << time << ", step " << k;
    }
    EXPECT_TRUE(later.is_at_goal({0}));
  }
}

TEST(StartTime, comes_in_spite_of_rounding) {
  EXPECT_LT(3 * 0.7, 2.1);
  EXPECT_FALSE(waits_to_start(2.1, 3 * 0.7));
  EXPECT_TRUE(waits_to_start(2.1, 2 * 0.7));
}

TEST(StartTime, is_each_robots_own) {
  Scenario scene = scene_of({});
  for (int k = 0; k < 6; ++k) {
    const double row = 3.0 * k;
    scene.robots.push_back(starting_at(1.5 * k, {0, row}, {12, row}));
  }
  Simulation simulation(scene, 1);
  std::vector<double> first(6, -1.0);
  while (simulation.time() < 20.0) {
    const double time = simulation.time();
    simulation.step();
    for (std::size_t k = 0; k < 6; ++k)
      if (first[k] < 0.0 && simulation.fleet().velocity[k] != Vec2{}) first[k] = time;
  }
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(first[k], 1.5 * static_cast<double>(k), 1e-9);
  EXPECT_TRUE(simulation.all_at_goal());
}

TEST(StartTime, leaves_the_room_to_others_that_pass) {
  Simulation simulation(
      scene_of({starting_at(40.0, {0, 0}, {0, 8}), robot_at({-8, 0.1}, {8, 0.1})}), 1);
  while (simulation.time() < 39.0) {
    simulation.step();
    EXPECT_GE(norm(simulation.fleet().position[0] - simulation.fleet().position[1]), 1.0);
  }
  EXPECT_TRUE(simulation.is_at_goal({1}));
  EXPECT_LT(norm(simulation.fleet().position[0]), 1.5) << "it makes room at most";
  run_until(simulation, 60.0);
  EXPECT_TRUE(simulation.all_at_goal());
}

// Robot 0 stands before the mouth: it would go first.
TEST(StartTime, holds_no_passage_from_outside) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots = {starting_at(60.0, {-7, 0}, {10, 3}), robot_at({12, 0}, {-10, -6})};
  Simulation simulation(scene, 1);
  while (simulation.time() < 59.0) {
    simulation.step();
    ASSERT_FALSE(simulation.wait({0}) || simulation.wait({1})) << simulation.time();
  }
  EXPECT_TRUE(simulation.is_at_goal({1}));
  run_until(simulation, 90.0);
  EXPECT_TRUE(simulation.is_at_goal({0}));
}

TEST(StartTime, lets_others_through_a_corridor) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::corridor(1.6))};
  scene.robots = {starting_at(40.0, {-2, 0}, {10, 3}), robot_at({12, 0}, {-10, -6})};
  Simulation simulation(scene, 1);
  run_until(simulation, 39.0);
  EXPECT_TRUE(simulation.is_at_goal({1}));
  run_until(simulation, 70.0);
  EXPECT_TRUE(simulation.all_at_goal());
}

// There are two doors. The one on the route of the robot is free: the robot has not waited for that
// door.
TEST(StartTime, is_no_time_that_a_robot_has_waited_at_a_door) {
  std::vector<Wall> walls = test::ring({{-16, -8}, {16, -8}, {16, 8}, {-16, 8}});
  walls.push_back({{0, -8}, {0, -0.8}, 0.0});
  walls.push_back({{0, 0.8}, {0, 4.2}, 0.0});
  walls.push_back({{0, 5.8}, {0, 8}, 0.0});
  Scenario scene;
  scene.obstacles = {test::pieces(walls)};
  scene.robots = {starting_at(40.0, {-6, 0}, {6, 0}), robot_at({-6, 1.3}, {-6, 1.3})};
  Simulation simulation(scene, 1);
  while (simulation.time() < 41.0) {
    simulation.step();
    ASSERT_LT(simulation.route({0}).length, 12.0 + 1e-9) << simulation.time();
  }
}

TEST(StartTime, goes_on_in_restored_states) {
  for (const Clock clock : {Clock::common, Clock::free}) {
    Scenario scene = scene_of({starting_at(4.0, {-8, 0}, {8, 1}), robot_at({8, 0}, {-8, 0}),
                               starting_at(2.0, {0, -8}, {0, 8})});
    scene.clock = clock;
    Simulation simulation(scene, 1), other(scene, 1);
    run_until(simulation, 3.0);
    const auto saved = simulation.save();
    Simulation restored(saved, 1);
    other.restore(saved);
    EXPECT_EQ(restored.setup({0}).start_time, 4.0);
    run_until(simulation, 3.9);
    EXPECT_LT(norm(simulation.fleet().position[0] - Vec2{-8, 0}), 1e-9);
    for (Simulation* run : {&simulation, &restored, &other}) run_until(*run, 30.0);
    EXPECT_EQ(restored.state_hash(), simulation.state_hash());
    EXPECT_EQ(other.state_hash(), simulation.state_hash());
    EXPECT_TRUE(simulation.all_at_goal());
  }
}

TEST(StartTime, holds_whatever_the_host_says_and_may_be_changed) {
  Simulation simulation(scene_of({starting_at(3.0, {0, 0}, {9, 0})}), 1);
  simulation.set_preferred_velocity({0}, Vec2{0, 1});
  run_until(simulation, 2.5);
  EXPECT_EQ(simulation.fleet().position[0], Vec2{});
  RobotSetup setup = simulation.setup({0});
  setup.start_time = 5.0;
  simulation.change_robot({0}, setup);
  run_until(simulation, 5.0);
  EXPECT_EQ(simulation.fleet().position[0], Vec2{});
  run_until(simulation, 7.0);
  EXPECT_EQ(simulation.fleet().position[0].x, 0.0);
  EXPECT_GT(simulation.fleet().position[0].y, 0.5);
}

TEST(StartTime, is_told_and_no_robot_is_stuck_before) {
  Simulation simulation(scene_of({starting_at(7.5, {0, 0}, {9, 0})}), 1);
  Events events(simulation, {.stuck_after = 1.0});
  EXPECT_EQ(simulation.explain({0}).sentence,
            "Robot 0 stays at rest: it starts at 7.5 s. Braking keeps clear of all others (safe).");
  while (simulation.time() < 20.0) {
    simulation.step();
    for (const Event& event : events.observe(simulation))
      EXPECT_EQ(event.kind, EventKind::arrived) << simulation.time();
  }
  EXPECT_EQ(simulation.explain({0}).sentence.find("starts at"), std::string::npos);
}

// Metrics do not know the time before.
TEST(StartTime, begins_the_trip) {
  const Scenario at_once = scene_of({robot_at({0, 0}, {9, 0})});
  const Scenario later = scene_of({starting_at(5.05, {0, 0}, {9, 0})});
  const auto measured = [](const Scenario& scene) {
    Simulation simulation(scene, 1);
    Metrics metrics(scene);
    metrics.observe(simulation);
    while (simulation.time() < 20.0) simulation.step(), metrics.observe(simulation);
    return metrics.summary();
  };
  const RunSummary first = measured(at_once), second = measured(later);
  EXPECT_NEAR(*first.metrics.extra_time_mean, *second.metrics.extra_time_mean, 1e-9);
  EXPECT_NEAR(*first.metrics.deadlock_time, *second.metrics.deadlock_time, 1e-9);
  EXPECT_NEAR(*first.last_arrival + 5.1, *second.last_arrival, 1e-9);
}

TEST(StartTime, is_refused_where_a_robot_cannot_wait) {
  const auto refused = [](RobotSetup robot) {
    return refusal([&] { Simulation(scene_of({robot}), 1); });
  };
  RobotSetup robot = starting_at(5.0, {0, 0}, {0, 0});
  robot.behavior = Behavior::parked;
  EXPECT_EQ(refused(robot), "robots.0.start_time: found 5, must be left out: it is parked");
  robot.behavior = Behavior::decides, robot.model = Airplane{};
  EXPECT_EQ(refused(robot),
            "robots.0.start_time: found 5, must be left out: it cannot wait at its start");
  EXPECT_EQ(refused(starting_at(-1.0, {0, 0}, {0, 0})),
            "robots.0.start_time: found -1, must be >= 0 s");
}

}  // namespace
}  // namespace avo
