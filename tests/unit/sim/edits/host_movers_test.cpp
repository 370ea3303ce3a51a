// SPDX-License-Identifier: Apache-2.0
// The host adds, changes and removes moving obstacles between two steps.
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "unit/sim/hosted.h"

namespace avo {
namespace {

using test::refusal;
using test::robot_at;
using test::run_for;
using test::two_lanes;

TEST(HostMovers, has_its_orders_saved_and_restored) {
  Scenario scene = two_lanes();
  scene.moving_obstacles = {{.position = {0, 30}, .velocity = {0.5, 0}}};
  Simulation simulation(scene, 1);
  const std::vector<std::byte> start = simulation.save();
  simulation.set_preferred_velocity({1}, Vec2{-0.5, 0.5});
  const MovingObstacleId came = simulation.add_moving_obstacle({.position = {0, -30}});
  simulation.remove_moving_obstacle({0});
  run_for(simulation, 3.0);
  Simulation again(simulation.save(), 1);
  EXPECT_EQ(again.preferred_velocity({1}), (Vec2{-0.5, 0.5}));
  ASSERT_EQ(again.moving_obstacles().id.size(), 1U);
  EXPECT_EQ(again.moving_obstacles().id[0], came);
  run_for(simulation, 5.0), run_for(again, 5.0);
  EXPECT_EQ(simulation.state_hash(), again.state_hash());
  EXPECT_EQ(again.add_moving_obstacle({.position = {0, -40}}).value, came.value + 1);
  simulation.restore(start);
  EXPECT_EQ(simulation.preferred_velocity({1}), std::nullopt);
  ASSERT_EQ(simulation.moving_obstacles().id.size(), 1U);
  EXPECT_EQ(simulation.moving_obstacles().id[0], MovingObstacleId{0});
  EXPECT_EQ(simulation.save(), start);
}

// After robots and movers have gone, questions by id are about the same bodies as before.
TEST(HostMovers, and_robots_are_asked_for_by_their_ids) {
  Scenario scene = two_lanes();
  scene.robots.push_back(robot_at({0, -3}, {9, -3}));
  scene.moving_obstacles = {{.position = {0, 30}}, {.position = {0, -9}}};
  Simulation simulation(scene, 1);
  const RobotSetup third = simulation.setup({2});
  simulation.remove_robot({0});
  simulation.remove_moving_obstacle({0});
  EXPECT_EQ(simulation.robot({2}).id, RobotId{2});
  EXPECT_EQ(simulation.setup({2}), third);
  EXPECT_EQ(simulation.index_of({2}), 1U);
  EXPECT_EQ(simulation.perceive({2}).source.front(), -1 - 1) << "the mover of id 1 is nearest";
  EXPECT_EQ(refusal([&] { static_cast<void>(simulation.is_at_goal({0})); }),
            "robot 0: found none of that id");
  EXPECT_EQ(refusal([&] { static_cast<void>(simulation.route({3})); }),
            "robot 3: found none of that id");
}

// A player walks towards robots, as the host says: within the limits that it declares, no robot in
// motion touches it.
TEST(HostMovers, moves_a_player_whom_robots_evade) {
  Scenario scene;
  for (int k = 0; k < 8; ++k)
    scene.robots.push_back(robot_at({-12.0, 2.5 * k - 9.0}, {12.0, 2.5 * k - 9.0}));
  scene.sensing_radius = 25.0;
  Simulation simulation(scene, 1);
  MetricsOptions all;
  Metrics metrics(scene, all);
  metrics.observe(simulation);
  MovingObstacle player{.position = {0, 0}, .max_deviation = 2.0, .max_speed = 1.0};
  player.radius = 0.4;
  const MovingObstacleId id = simulation.add_moving_obstacle(player);
  for (int k = 0; k < 400; ++k) {
    const double angle = 0.05 * k;
    const MovingObstacleView movers = simulation.moving_obstacles();
    player.position = movers.position[0];
    player.velocity = {0.9 * std::cos(angle), 0.9 * std::sin(angle)};
    simulation.change_moving_obstacle(id, player);
    simulation.step();
    metrics.observe(simulation);
  }
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.mover_collisions_in_motion, 0);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.arrived, 8U);
  simulation.remove_moving_obstacle(id);
  EXPECT_TRUE(simulation.moving_obstacles().id.empty());
  run_for(simulation, 1.0);
}

TEST(HostMovers, is_refused_movers_that_nobody_could_evade) {
  Simulation simulation(two_lanes(), 1);
  run_for(simulation, 5.0);
  const Vec2 p = simulation.robot({0}).position;
  const std::string refused = refusal([&] {
    simulation.add_moving_obstacle({.position = {p.x + 1.3, p.y}});
  });
  EXPECT_NE(refused.find("moving obstacle 0"), std::string::npos) << refused;
  EXPECT_TRUE(simulation.moving_obstacles().id.empty());
  EXPECT_EQ(refusal([&] {
              simulation.add_moving_obstacle({.position = {0, 50}, .radius = -1.0});
            }),
            "moving obstacle 0: radius: found -1, must be > 0 m");
  EXPECT_EQ(refusal([&] { simulation.remove_moving_obstacle({3}); }),
            "moving obstacle 3: found none of that id");
  EXPECT_EQ(refusal([&] { simulation.change_moving_obstacle({3}, {}); }),
            "moving obstacle 3: found none of that id");
}

TEST(HostMovers, are_named_by_their_ids_where_a_start_is_refused) {
  Simulation simulation(two_lanes(), 1);
  const MovingObstacleId first = simulation.add_moving_obstacle({.position = {0, 50}});
  const MovingObstacleId second = simulation.add_moving_obstacle({.position = {0, 60}});
  simulation.remove_moving_obstacle(first);
  RobotSetup robot = simulation.setup({0});
  robot.position = {0, 60.2};
  const std::string refused = refusal([&] { simulation.add_robot(robot); });
  EXPECT_NE(refused.find("moving obstacle " + std::to_string(second.value) + " overlap"),
            std::string::npos)
      << refused;
}

// As a scene with them from the start.
TEST(HostMovers, adds_movers_as_a_scene_has_them) {
  Scenario scene = two_lanes();
  const std::vector<MovingObstacle> movers{
      {.position = {0, -20}, .velocity = {0, 0.8}, .max_deviation = 0.5, .max_speed = 1.0},
      {.position = {5, 15}, .max_deviation = 1.0, .max_speed = 0.9, .path = {{5, -5}, {5, 15}}}};
  scene.sensing_radius = 30.0;
  Simulation added(scene, 1);
  for (const MovingObstacle& mover : movers) added.add_moving_obstacle(mover);
  scene.moving_obstacles = movers;
  Simulation whole(scene, 1);
  run_for(added, 40.0), run_for(whole, 40.0);
  EXPECT_EQ(added.state_hash(), whole.state_hash());
}

// Robots go around movers at rest: what is saved between an edit and a step knows it.
TEST(HostMovers, saves_between_an_edit_of_movers_and_a_step) {
  for (const bool walled : {false, true}) {
    Scenario scene = two_lanes();
    if (walled) scene.obstacles = {{{{{{-5, 8}, {5, 8}}, false}}, 0.0, Fill::none}};
    Simulation simulation(scene, 1);
    run_for(simulation, 1.0);
    MovingObstacle mover{.position = {0, 14}, .max_deviation = 1.0, .max_speed = 1.0};
    const auto expect_same = [&](const char* what) {
      Simulation again(simulation.save(), 1);
      Simulation other(scene, 1);
      other.restore(simulation.save());
      for (int k = 0; k < 50; ++k) simulation.step(), again.step(), other.step();
      EXPECT_EQ(simulation.state_hash(), again.state_hash()) << what << walled;
      EXPECT_EQ(simulation.state_hash(), other.state_hash()) << what << walled;
    };
    const MovingObstacleId id = simulation.add_moving_obstacle(mover);
    expect_same("came at rest");
    mover.velocity = {0, 0.5};
    simulation.change_moving_obstacle(id, mover);
    expect_same("moves on");
    mover.position = {1, 20}, mover.velocity = {};
    simulation.change_moving_obstacle(id, mover);
    expect_same("came to rest");
    simulation.remove_moving_obstacle(id);
    expect_same("is gone");
  }
}

TEST(HostMovers, keeps_movers_and_robots_in_sight) {
  Scenario scene = two_lanes();
  Simulation grows(scene, 1);
  const double before = grows.sensing_radius();
  const MovingObstacle fast{.position = {0, 90}, .velocity = {0, -9}, .radius = 3.0};
  grows.add_moving_obstacle(fast);
  EXPECT_GT(grows.sensing_radius(), before + 3.0);
  scene.sensing_radius = before;
  Simulation fixed(scene, 1);
  EXPECT_NE(refusal([&] { fixed.add_moving_obstacle(fast); }).find("has to be seen from"),
            std::string::npos);
  // it stops from 2 m/s with a fiftieth of its brakes
  run_for(fixed, 5.0);
  RobotSetup setup = fixed.setup({0});
  setup.max_speed = 0.5, setup.max_acceleration = 0.02;
  EXPECT_NE(refusal([&] { fixed.change_robot({0}, setup); }).find("has to be seen from"),
            std::string::npos);
}

}  // namespace
}  // namespace avo
