// SPDX-License-Identifier: Apache-2.0
// The host adds, changes and removes moving obstacles of space between two steps.
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/space/metrics.h"
#include "avo/space/simulation.h"
#include "support/refusal.h"

namespace avo::space::tests {
namespace {

using test::refusal;

// Two robots that rest at their goals, 6 m apart along y.
Scenario two_at_rest() {
  Scenario scene;
  scene.robots.resize(2);
  scene.robots[0].position = scene.robots[0].goal = {0, -3, 0};
  scene.robots[1].position = scene.robots[1].goal = {0, 3, 0};
  return scene;
}

Scenario crossing() {
  Scenario scene;
  for (int k = 0; k < 8; ++k) {
    RobotSetup& robot = scene.robots.emplace_back();
    const double x = k % 2 == 0 ? -9.0 : 9.0;
    robot.position = {x, 2.0 * k - 7.0, 0.5 * (k % 3)}, robot.goal = {-x, 2.0 * k - 7.0, 0.0};
  }
  return scene;
}

MovingObstacle moving(Vec3 position, Vec3 velocity, double radius = 0.5) {
  MovingObstacle obstacle;
  obstacle.position = position, obstacle.velocity = velocity, obstacle.radius = radius;
  return obstacle;
}

void run_for(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

// As a scene with them from the start, also where they are sensed late, with noise, or not at all.
TEST(SpaceMoverEdits, add_moving_obstacles_as_a_scene_has_them) {
  for (const bool is_exact : {true, false}) {
    Scenario scene = crossing();
    scene.sensing_radius = 60.0;
    if (!is_exact) scene.sensing = {.noise = {.position = 0.02}, .delay = 2, .dropped = 0.2};
    MovingObstacle on_trajectory;
    on_trajectory.trajectory = {{0.0, {3, 0, -9}}, {9.0, {-3, 0, 9}}};
    const std::vector<MovingObstacle> obstacles{moving({0, -20, 0}, {0, 2, 0}), on_trajectory};
    Simulation added(scene);
    for (const MovingObstacle& obstacle : obstacles) added.add_moving_obstacle(obstacle);
    scene.moving_obstacles = obstacles;
    Simulation whole(scene);
    run_for(added, 120), run_for(whole, 120);
    EXPECT_EQ(added.state_hash(), whole.state_hash()) << is_exact;
    EXPECT_EQ(added.movers()[0].position, whole.movers()[0].position);
    ASSERT_EQ(added.moving_obstacle_ids().size(), 2U);
    EXPECT_EQ(added.scenario().moving_obstacles, obstacles);
  }
}

TEST(SpaceMoverEdits, have_ids_that_are_never_used_again) {
  Scenario scene = two_at_rest();
  scene.moving_obstacles = {moving({0, 40, 0}, {}), moving({0, -40, 0}, {})};
  Simulation simulation(scene);
  run_for(simulation, 10);
  simulation.remove_moving_obstacle({1});
  EXPECT_EQ(simulation.add_moving_obstacle(moving({30, 0, 0}, {1, 0, 0})).value, 2U);
  simulation.remove_moving_obstacle({0});
  ASSERT_EQ(simulation.moving_obstacle_ids().size(), 1U);
  EXPECT_EQ(simulation.moving_obstacle_ids()[0], MovingObstacleId{2});
  run_for(simulation, 10);
  // it counts its own time, and was there for 10 steps of 0.1 s
  EXPECT_NEAR(simulation.movers()[0].position.x, 31.0, 1e-12);
  EXPECT_NEAR(simulation.movers_before()[0].position.x, 30.9, 1e-12);
  simulation.change_moving_obstacle({2}, moving({0, 30, 0}, {0, 2, 0}));
  EXPECT_EQ(simulation.movers()[0].position, (Vec3{0, 30, 0}));
  run_for(simulation, 10);
  EXPECT_NEAR(simulation.movers()[0].position.y, 32.0, 1e-12);
  EXPECT_EQ(refusal([&] { simulation.remove_moving_obstacle({1}); }),
            "moving obstacle 1: found none of that id");
  EXPECT_EQ(refusal([&] { simulation.change_moving_obstacle({0}, {}); }),
            "moving obstacle 0: found none of that id");
}

// A player flies towards robots, as the host says. Within the limits that it declares it touches no
// robot in motion, and the metrics follow it.
TEST(SpaceMoverEdits, move_a_player_whom_robots_evade) {
  Scenario scene = crossing();
  scene.sensing_radius = 25.0;
  Simulation simulation(scene);
  Metrics metrics(scene);
  metrics.observe(simulation);
  MovingObstacle player = moving({0, 0, 0}, {}, 0.4);
  player.max_deviation = 2.0, player.max_speed = 1.0;
  const MovingObstacleId id = simulation.add_moving_obstacle(player);
  for (int k = 0; k < 300; ++k) {
    const double angle = 0.05 * k;
    player.position = simulation.movers()[0].position;
    player.velocity = {0.9 * std::cos(angle), 0.9 * std::sin(angle), 0.0};
    simulation.change_moving_obstacle(id, player);
    simulation.step();
    metrics.observe(simulation);
  }
  EXPECT_EQ(metrics.summary().mover_collisions_in_motion, 0);
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
  EXPECT_EQ(metrics.summary().arrived, 8);
  simulation.remove_moving_obstacle(id);
  run_for(simulation, 1);
  metrics.observe(simulation);
}

// It flies through both robots, which decide without a certificate, and metrics count both.
TEST(SpaceMoverEdits, are_judged_from_where_they_come) {
  Scenario scene = two_at_rest();
  scene.certificate = Certificate::none;
  Simulation simulation(scene);
  Metrics metrics(scene);
  metrics.observe(simulation);
  run_for(simulation, 1);
  metrics.observe(simulation);
  const MovingObstacleId first = simulation.add_moving_obstacle(moving({0, -6, 0}, {0, 100, 0}));
  run_for(simulation, 1);  // from -6 m to 4 m
  metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().mover_collisions, 2);
  simulation.remove_moving_obstacle(first);
  simulation.add_moving_obstacle(moving({0, -30, 0}, {0, 400, 0}));
  run_for(simulation, 1);
  metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().mover_collisions, 4);
}

// With a delay of 0.3 s, and almost no measurement that succeeds, robots know where it came.
TEST(SpaceMoverEdits, are_known_to_robots_from_where_they_come) {
  Scenario scene = two_at_rest();
  scene.sensing = {.delay = 3, .dropped = 0.99};
  scene.sensing_error = SensingError{};
  scene.sensing_radius = 60.0;
  Simulation simulation(scene);
  Metrics metrics(scene);
  run_for(simulation, 20);
  metrics.observe(simulation);
  simulation.add_moving_obstacle(moving({9, -3, 0}, {-4, 0, 0}));
  bool evades = false;
  for (int k = 0; k < 40; ++k) {
    simulation.step();
    metrics.observe(simulation);
    evades = evades || simulation.plans()[0].evading;
  }
  EXPECT_TRUE(evades);
  EXPECT_EQ(metrics.summary().mover_collisions, 0);
}

TEST(SpaceMoverEdits, are_refused_where_nobody_could_brake) {
  Simulation simulation(crossing());
  run_for(simulation, 30);
  const Vec3 p = simulation.robots()[0].position;
  const std::string refused = refusal([&] {
    simulation.add_moving_obstacle(moving(p + Vec3{1.3, 0, 0}, {}));
  });
  EXPECT_EQ(refused.find("robot 0 and moving obstacle 0 start too fast for their distance: "), 0U)
      << refused;
  Simulation resting(two_at_rest());
  EXPECT_EQ(refusal([&] {
              resting.add_moving_obstacle(moving({0, 3.75, 0}, {}));
            }),
            "robot 1 and moving obstacle 0 overlap at the start: found 0.75 m between the centers, "
            "must be >= 0.5 + 0.5 = 1 m; move them apart");
  EXPECT_EQ(refusal([&] {
              simulation.add_moving_obstacle(moving({0, 0, 50}, {}, -1.0));
            }),
            "moving obstacle 0: radius: found -1, must be > 0 m");
  MovingObstacle backwards;
  backwards.trajectory = {{2.0, {}}, {1.0, {}}};
  EXPECT_NE(refusal([&] {
              simulation.add_moving_obstacle(backwards);
            }).find("moving obstacle 0: trajectory: found 1 s after 2 s"),
            std::string::npos);
  EXPECT_TRUE(simulation.moving_obstacle_ids().empty());
  EXPECT_EQ(simulation.add_moving_obstacle(moving({0, 0, 50}, {})).value, 0U);
}

TEST(SpaceMoverEdits, keep_moving_obstacles_in_sight) {
  const MovingObstacle fast = moving({0, 0, 105}, {0, 0, -20}, 5.0);
  Scenario scene = crossing();
  Simulation grows(scene);
  Metrics metrics(scene);
  metrics.observe(grows);
  grows.add_moving_obstacle(fast);
  for (int k = 0; k < 80; ++k) grows.step(), metrics.observe(grows);
  EXPECT_GT(metrics.summary().mover_collisions, 0);
  EXPECT_EQ(metrics.summary().mover_collisions_in_motion, 0);
  scene.sensing_radius = sensing_radius_of(scene);
  Simulation fixed(scene);
  const std::string refused = refusal([&] { fixed.add_moving_obstacle(fast); });
  EXPECT_NE(refused.find("moving obstacle 0: has to be seen from"), std::string::npos) << refused;
  scene.sensing.delay = 2;
  MovingObstacle wild = moving({0, 0, 50}, {});
  wild.max_deviation = 9.0;
  scene.sensing_radius.reset();
  Simulation late(scene);
  EXPECT_NE(refusal([&] { late.add_moving_obstacle(wild); }).find("beyond the sensing_error"),
            std::string::npos);
}

}  // namespace
}  // namespace avo::space::tests
