// SPDX-License-Identifier: Apache-2.0
// Robots come and go between steps under ids that never change.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::dense_avo_scene;
using test::dense_scene;
using test::robot_at;

RobotSetup far_robot() {
  return robot_at({5e4, 5e4}, {5e4, 5e4});
}

TEST(Fleet, ids_are_never_reused) {
  Simulation simulation(dense_scene(20, Motion::held), 1);
  for (std::uint64_t k = 0; k < 20; ++k) EXPECT_EQ(simulation.fleet().id[k].value, k);
  simulation.remove_robot({19});
  EXPECT_EQ(simulation.add_robot(far_robot()).value, 20u);
  simulation.remove_robot({20});
  EXPECT_EQ(simulation.add_robot(far_robot()).value, 21u);
  simulation.remove_robot({0});
  EXPECT_EQ(simulation.fleet().id.front().value, 1u);
  EXPECT_EQ(simulation.fleet().id.back().value, 21u);
  EXPECT_EQ(simulation.fleet().id.size(), 19u);
}

TEST(Fleet, unknown_ids_are_refused_and_change_nothing) {
  Simulation simulation(dense_scene(10, Motion::held), 1);
  simulation.remove_robot({4});
  const std::uint64_t hash = simulation.state_hash();
  for (const std::uint64_t unknown : {std::uint64_t{4}, std::uint64_t{10}, ~std::uint64_t{0}}) {
    EXPECT_THROW(simulation.remove_robot({unknown}), Error);
    EXPECT_THROW(simulation.set_goal({unknown}, {}), Error);
  }
  try {
    simulation.remove_robot({4});
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("robot 4"), std::string::npos) << error.what();
  }
  EXPECT_EQ(simulation.state_hash(), hash);
}

TEST(Fleet, a_negative_number_of_threads_is_refused) {
  EXPECT_THROW(Simulation(dense_scene(2, Motion::held), -1), Error);
}

TEST(Fleet, bad_robots_and_goals_are_refused_and_change_nothing) {
  Simulation simulation(dense_scene(10, Motion::held), 1);
  const std::uint64_t hash = simulation.state_hash();
  RobotSetup bad = far_robot();
  bad.radius = -1.0;
  EXPECT_THROW(simulation.add_robot(bad), Error);
  bad = far_robot();
  bad.position.x = std::nan("");
  EXPECT_THROW(simulation.add_robot(bad), Error);
  try {
    simulation.set_goal({3}, {std::nan(""), 0});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "robot 3: goal.0: found nan, must be a finite number");
  }
  EXPECT_EQ(simulation.state_hash(), hash);
  EXPECT_EQ(simulation.add_robot(far_robot()).value, 10u);
}

TEST(Fleet, detours_are_shown_and_stay_with_their_robots) {
  Simulation simulation(dense_avo_scene(40, Motion::held, Certificate::braking_trajectories, 3), 1);
  for (int k = 0; k < 40; ++k) simulation.step();
  const std::vector<Detour> before(simulation.fleet().detour.begin(),
                                   simulation.fleet().detour.end());
  ASSERT_EQ(before.size(), 40u);
  std::size_t turned = 0;
  while (turned < 40 && before[turned].angle == 0.0) ++turned;
  ASSERT_LT(turned, 40u) << "a crowd in which nobody is blocked";
  simulation.remove_robot({turned == 0 ? std::uint64_t{39} : std::uint64_t{0}});
  const std::size_t now = turned == 0 ? 0 : turned - 1;
  EXPECT_EQ(simulation.fleet().detour[now].angle, before[turned].angle);
  EXPECT_EQ(simulation.perceive({turned}).detour.angle, before[turned].angle);
}

// In the middle of a run: the others do not notice a robot that is out of sight.
TEST(Fleet, a_far_robot_changes_no_bit_of_the_others) {
  for (const Scenario& scene :
       {dense_scene(60, Motion::held, 9), dense_scene(60, Motion::exponential, 9),
        dense_avo_scene(60, Motion::held, Certificate::braking_trajectories, 9)}) {
    Simulation plain(scene, 2), other(scene, 2);
    RobotId far{};
    for (int k = 0; k < 120; ++k) {
      RobotSetup slow = far_robot();  // seen early enough under every certificate
      slow.max_speed = slow.preferred_speed = 0.1;
      if (k == 30) far = other.add_robot(slow);
      if (k == 80) other.remove_robot(far);
      plain.step();
      other.step();
      for (std::size_t i = 0; i < 60; ++i) {
        ASSERT_EQ(plain.fleet().position[i], other.fleet().position[i]) << "step " << k;
        ASSERT_EQ(plain.fleet().velocity[i], other.fleet().velocity[i]);
      }
    }
    EXPECT_EQ(plain.state_hash(), other.state_hash());
  }
}

TEST(Fleet, removing_keeps_each_column_with_its_robot) {
  const Scenario scene = dense_scene(30, Motion::held, 2);
  Simulation simulation(scene, 1);
  simulation.step();
  const Vec2 position = simulation.fleet().position[17];
  const Vec2 velocity = simulation.fleet().velocity[17];
  const double heading = simulation.fleet().heading[20];
  const Plan plan = simulation.fleet().plan[17];
  simulation.set_goal({17}, {1, 2});
  simulation.remove_robot({3});
  const FleetView fleet = simulation.fleet();
  ASSERT_EQ(fleet.id[16].value, 17u);
  EXPECT_EQ(fleet.position[16], position);
  EXPECT_EQ(fleet.velocity[16], velocity);
  EXPECT_EQ(fleet.heading[19], heading);
  EXPECT_EQ(fleet.setup[16].radius, scene.robots[17].radius);
  EXPECT_EQ(fleet.plan[16].new_velocity, plan.new_velocity);
  const Vec2 goal{1, 2};
  EXPECT_EQ(fleet.goal[16], goal);
}

// A robot that appears on the course of another one is seen in the next step. One that is gone is
// seen no longer.
TEST(Fleet, newcomers_are_seen_at_once) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {20, 0}), robot_at({0, 50}, {0, 50})};
  Simulation simulation(scene, 1);
  for (int k = 0; k < 10; ++k) simulation.step();
  EXPECT_TRUE(simulation.perceive({0}).neighbors.empty());
  const RobotId newcomer = simulation.add_robot(robot_at({6, 0.1}, {6, 0.1}));
  ASSERT_EQ(simulation.perceive({0}).neighbors.size(), 1u);
  EXPECT_EQ(simulation.perceive({0}).source[0], 2);
  simulation.step();
  EXPECT_NE(simulation.fleet().velocity[0].y, 0.0);
  simulation.remove_robot(newcomer);
  EXPECT_TRUE(simulation.perceive({0}).neighbors.empty());
}

TEST(Fleet, time_is_the_number_of_steps) {
  Scenario scene = dense_scene(5, Motion::held);
  scene.time_step = 0.05;
  Simulation simulation(scene, 1);
  for (int k = 0; k < 37; ++k) simulation.step();
  EXPECT_EQ(simulation.steps(), 37);
  EXPECT_EQ(simulation.time(), 37 * 0.05);
}

TEST(Fleet, obstacles_keep_their_acceleration_exactly) {
  Scenario scene;
  scene.robots = {robot_at({500, 500}, {500, 500})};
  scene.sensing_radius = 23.0;
  scene.moving_obstacles = {{{1, 2}, {0.5, -0.25}, {0.125, 0.0625}, 0.5}};
  Simulation simulation(scene, 1);
  for (int k = 0; k < 100; ++k) simulation.step();
  const double t = 10.0;
  EXPECT_NEAR(simulation.moving_obstacles().position[0].x, 1 + 0.5 * t + 0.0625 * t * t, 1e-12);
  EXPECT_NEAR(simulation.moving_obstacles().position[0].y, 2 - 0.25 * t + 0.03125 * t * t, 1e-12);
  EXPECT_NEAR(simulation.moving_obstacles().velocity[0].x, 0.5 + 0.125 * t, 1e-13);
}

TEST(Fleet, an_empty_simulation_steps) {
  Simulation simulation(Scenario{}, 2);
  simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_EQ(simulation.add_robot(far_robot()).value, 0u);
  simulation.step();
  EXPECT_EQ(simulation.fleet().id.size(), 1u);
}

}  // namespace
}  // namespace avo
