// SPDX-License-Identifier: Apache-2.0
// The host changes robots, tells them where to go, and moves obstacles, between two steps.
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

template <typename Call>
std::string said(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void run(Simulation& simulation, double seconds) {
  const double until = simulation.time() + seconds - 1e-9;
  while (simulation.time() < until) simulation.step();
}

double least_clearance(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  double least = 1e9;
  for (std::size_t a = 0; a < fleet.id.size(); ++a)
    for (std::size_t b = a + 1; b < fleet.id.size(); ++b)
      least = std::min(least, norm(fleet.position[a] - fleet.position[b]) - fleet.setup[a].radius -
                                  fleet.setup[b].radius);
  return least;
}

Scenario two_lanes() {
  Scenario scene;
  scene.robots = {robot_at({-20, 0}, {40, 0}), robot_at({20, 3}, {-40, 3})};
  return scene;
}

TEST(Host, changes_what_a_robot_can_do_and_it_slows_down) {
  Simulation simulation(two_lanes(), 1);
  run(simulation, 6.0);
  EXPECT_GT(norm(simulation.robot(0).velocity), 1.5);
  RobotSetup setup = simulation.setup(0);
  const std::uint64_t roster = simulation.roster();
  setup.max_speed = setup.preferred_speed = 0.5;
  setup.priority = 3.0, setup.arrival_distance = 0.2;
  setup.position = {99, 99}, setup.goal = {0, 77};  // not read
  simulation.change_robot(simulation.fleet().id[0], setup);
  EXPECT_NE(simulation.roster(), roster);
  EXPECT_EQ(simulation.setup(0).max_speed, 0.5);
  EXPECT_EQ(simulation.setup(0).priority, 3.0);
  EXPECT_EQ(simulation.setup(0).arrival_distance, 0.2);
  EXPECT_EQ(simulation.setup(0).goal, (Vec2{40, 0}));
  const double before = norm(simulation.robot(0).velocity);
  simulation.step();
  EXPECT_GE(norm(simulation.robot(0).velocity), before - 0.1 - 1e-9) << "a_max is 1 m/s^2";
  run(simulation, 4.0);
  EXPECT_LE(norm(simulation.robot(0).velocity), 0.5 + 1e-9);
  Simulation again(simulation.save(), 1);
  run(simulation, 5.0), run(again, 5.0);
  EXPECT_EQ(simulation.state_hash(), again.state_hash());
}

// The change alone matters, not the way in which it was made.
TEST(Host, changes_are_those_of_a_robot_that_was_so_from_the_start) {
  Scenario scene = two_lanes();
  Simulation changed(scene, 1);
  RobotSetup other = scene.robots[1];
  other.radius = 0.3, other.max_acceleration = 2.0, other.max_braking = 0.8, other.priority = 2.0;
  other.max_speed = 1.5, other.preferred_speed = 1.2, other.time_horizon = 2.0;
  changed.change_robot({1}, other);
  scene.robots[1] = other;
  scene.sensing_radius = changed.sensing_radius();
  Simulation told(scene, 1);
  run(changed, 30.0), run(told, 30.0);
  EXPECT_EQ(changed.state_hash(), told.state_hash());
}

TEST(Host, is_refused_changes_that_break_the_promise) {
  Scenario scene;
  scene.sensing_radius = 12.0;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({1.2, 0}, {1.2, 0})};
  scene.obstacles = {{{{{{-5, 1}, {5, 1}}, false}}, 0.0, Fill::none}};
  Simulation simulation(scene, 1);
  RobotSetup setup = simulation.setup(0);
  setup.radius = 0.8;
  const std::string beside = said([&] { simulation.change_robot({0}, setup); });
  EXPECT_NE(beside.find("robot 0"), std::string::npos) << beside;
  EXPECT_EQ(simulation.setup(0).radius, 0.5);
  setup.radius = 0.6;
  EXPECT_EQ(said([&] { simulation.change_robot({0}, setup); }), "");
  setup.max_speed = 50.0;
  const std::string fast = said([&] { simulation.change_robot({0}, setup); });
  EXPECT_NE(fast.find("sensing_radius is 12"), std::string::npos) << fast;
  setup = simulation.setup(0), setup.max_acceleration = -1.0;
  EXPECT_EQ(said([&] { simulation.change_robot({0}, setup); }),
            "robot 0: max_acceleration: found -1, must be > 0 m/s^2");
  setup = simulation.setup(0), setup.model = Car{};
  EXPECT_EQ(said([&] { simulation.change_robot({0}, setup); }),
            "robot 0: model: found another one, must be the one that it has");
  EXPECT_NE(said([&] { simulation.change_robot({7}, setup); }), "");
  run(simulation, 2.0);
  EXPECT_GE(least_clearance(simulation), 0.0);
}

TEST(Host, tells_a_robot_its_preferred_velocity_and_takes_it_back) {
  Scenario scene = two_lanes();
  scene.robots[1].goal = {-20, 0}, scene.robots[1].position = {20, 0};
  Simulation simulation(scene, 1);
  simulation.set_preferred_velocity({0}, Vec2{0, 1.0});
  EXPECT_EQ(simulation.preferred_velocity(0), (Vec2{0, 1.0}));
  EXPECT_EQ(simulation.preferred_velocity(1), std::nullopt);
  run(simulation, 20.0);
  EXPECT_NEAR(simulation.robot(0).position.x, -20.0, 0.3);
  EXPECT_GT(simulation.robot(0).position.y, 15.0);
  EXPECT_EQ(simulation.perceive(0).guide, Guide::host);
  EXPECT_EQ(simulation.perceive(0).robot.preferred_velocity, (Vec2{0, 1.0}));
  simulation.set_preferred_velocity({0}, std::nullopt);
  run(simulation, 60.0);
  EXPECT_TRUE(simulation.is_at_goal(0));
}

// At its goal too it goes where it is told, and then it is not at its goal.
TEST(Host, leads_a_robot_through_a_crowd_without_contact) {
  Scenario scene;
  for (int k = 0; k < 25; ++k) {
    const Vec2 place{2.0 * (k % 5), 2.0 * (k / 5)};
    scene.robots.push_back(robot_at(place, place));
  }
  scene.robots[0].position = scene.robots[0].goal = {-4, 4};
  Simulation simulation(scene, 1);
  EXPECT_TRUE(simulation.is_at_goal(0));
  simulation.set_preferred_velocity({0}, Vec2{1.5, 0});
  EXPECT_FALSE(simulation.is_at_goal(0));
  double least = 1e9;
  for (int k = 0; k < 250; ++k) {
    simulation.step();
    least = std::min(least, least_clearance(simulation));
  }
  EXPECT_GE(least, 0.0);
  EXPECT_GT(simulation.robot(0).position.x, 9.0);
}

TEST(Host, has_its_orders_saved_and_restored) {
  Scenario scene = two_lanes();
  scene.moving_obstacles = {{.position = {0, 30}, .velocity = {0.5, 0}}};
  Simulation simulation(scene, 1);
  const std::vector<std::byte> start = simulation.save();
  simulation.set_preferred_velocity({1}, Vec2{-0.5, 0.5});
  const MovingObstacleId came = simulation.add_moving_obstacle({.position = {0, -30}});
  simulation.remove_moving_obstacle({0});
  run(simulation, 3.0);
  Simulation again(simulation.save(), 1);
  EXPECT_EQ(again.preferred_velocity(1), (Vec2{-0.5, 0.5}));
  ASSERT_EQ(again.obstacles().id.size(), 1U);
  EXPECT_EQ(again.obstacles().id[0], came);
  run(simulation, 5.0), run(again, 5.0);
  EXPECT_EQ(simulation.state_hash(), again.state_hash());
  EXPECT_EQ(again.add_moving_obstacle({.position = {0, -40}}).value, came.value + 1);
  simulation.restore(start);
  EXPECT_EQ(simulation.preferred_velocity(1), std::nullopt);
  ASSERT_EQ(simulation.obstacles().id.size(), 1U);
  EXPECT_EQ(simulation.obstacles().id[0], MovingObstacleId{0});
  EXPECT_EQ(simulation.save(), start);
}

// A player walks towards robots, as the host says: within the limits that it declares, no robot in
// motion touches it.
TEST(Host, moves_a_player_whom_robots_evade) {
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
    const ObstacleView movers = simulation.obstacles();
    player.position = movers.position[0];
    player.velocity = {0.9 * std::cos(angle), 0.9 * std::sin(angle)};
    simulation.change_moving_obstacle(id, player);
    simulation.step();
    metrics.observe(simulation);
  }
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.obstacle_collisions_in_motion, 0);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.arrived, 8U);
  simulation.remove_moving_obstacle(id);
  EXPECT_TRUE(simulation.obstacles().id.empty());
  run(simulation, 1.0);
}

TEST(Host, is_refused_movers_that_nobody_could_evade) {
  Simulation simulation(two_lanes(), 1);
  run(simulation, 5.0);
  const Vec2 p = simulation.robot(0).position;
  const std::string refused = said([&] {
    simulation.add_moving_obstacle({.position = {p.x + 1.3, p.y}});
  });
  EXPECT_NE(refused.find("moving obstacle 0"), std::string::npos) << refused;
  EXPECT_TRUE(simulation.obstacles().id.empty());
  EXPECT_EQ(said([&] {
              simulation.add_moving_obstacle({.position = {0, 50}, .radius = -1.0});
            }),
            "moving obstacle 0: radius: found -1, must be > 0 m");
  EXPECT_EQ(said([&] { simulation.remove_moving_obstacle({3}); }),
            "moving obstacle 3: found none of that id");
  EXPECT_EQ(said([&] { simulation.change_moving_obstacle({3}, {}); }),
            "moving obstacle 3: found none of that id");
}

// As a scene with them from the start.
TEST(Host, adds_movers_as_a_scene_has_them) {
  Scenario scene = two_lanes();
  const std::vector<MovingObstacle> movers{
      {.position = {0, -20}, .velocity = {0, 0.8}, .max_deviation = 0.5, .max_speed = 1.0},
      {.position = {5, 15}, .max_deviation = 1.0, .max_speed = 0.9, .path = {{5, -5}, {5, 15}}}};
  scene.sensing_radius = 30.0;
  Simulation added(scene, 1);
  for (const MovingObstacle& mover : movers) added.add_moving_obstacle(mover);
  scene.moving_obstacles = movers;
  Simulation whole(scene, 1);
  run(added, 40.0), run(whole, 40.0);
  EXPECT_EQ(added.state_hash(), whole.state_hash());
}

}  // namespace
}  // namespace avo
