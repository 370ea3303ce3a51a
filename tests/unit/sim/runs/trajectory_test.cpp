// SPDX-License-Identifier: Apache-2.0
// Moving obstacles that are where trajectories say.
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/saving.h"

namespace avo {
namespace {

using test::refusal;
using test::robot_at;

MovingObstacle on(std::vector<TimedPlace> places, double radius = 0.3) {
  MovingObstacle obstacle;
  obstacle.radius = radius;
  obstacle.trajectory = std::move(places);
  start_on_trajectory(obstacle);
  return obstacle;
}

// It waits for a second, goes to the right, and then upwards, twice as fast.
MovingObstacle walker() {
  return on({{1.0, {0, 0}}, {3.0, {2, 0}}, {4.0, {2, 2}}});
}

TEST(Trajectory, is_followed_straight_and_evenly) {
  const MovingObstacle obstacle = walker();
  const auto expect_at = [&](double time, Vec2 position, Vec2 velocity) {
    const PathWalk walk = on_trajectory(obstacle, time);
    EXPECT_EQ(walk.position, position) << time;
    EXPECT_EQ(walk.velocity, velocity) << time;
  };
  expect_at(-5.0, {0, 0}, {0, 0});
  expect_at(0.5, {0, 0}, {0, 0});
  expect_at(1.0, {0, 0}, {1, 0});  // with what it goes on
  expect_at(2.5, {1.5, 0}, {1, 0});
  expect_at(3.0, {2, 0}, {0, 2});
  expect_at(3.5, {2, 1}, {0, 2});
  expect_at(4.0, {2, 2}, {0, 0});
  expect_at(1e9, {2, 2}, {0, 0});
  EXPECT_EQ(on({{-1.0, {0, 0}}, {1.0, {4, 0}}}).position, (Vec2{2, 0}));
  EXPECT_EQ(on({{-1.0, {0, 0}}, {1.0, {4, 0}}}).velocity, (Vec2{2, 0}));
  EXPECT_EQ(on({{2.0, {3, 1}}}).position, (Vec2{3, 1}));
}

TEST(Trajectory, is_where_a_mover_is_at_the_ends_of_steps) {
  for (const Clock clock : {Clock::common, Clock::free}) {
    Scenario scene;
    scene.clock = clock;
    scene.sensing_radius = 20.0;
    scene.robots = {robot_at({-9, 6}, {9, 6}), robot_at({9, 8}, {-9, 8})};
    scene.moving_obstacles = {walker()};
    Simulation simulation(scene, 1);
    for (int step = 0; step < 60; ++step) {
      const PathWalk walk = on_trajectory(scene.moving_obstacles[0], simulation.time());
      EXPECT_EQ(simulation.moving_obstacles().position[0], walk.position);
      EXPECT_EQ(simulation.moving_obstacles().velocity[0], walk.velocity);
      for (const Neighbor& seen : simulation.perceive({0}).neighbors) {
        if (seen.behavior != Behavior::moves_on) continue;
        EXPECT_EQ(seen.position, walk.position);
        EXPECT_EQ(seen.velocity, walk.velocity);
      }
      simulation.step();
    }
  }
}

TEST(Trajectory, is_sensed_late_where_it_was) {
  Scenario scene;
  scene.sensing.delay = 4;
  scene.sensing_radius = 20.0;
  scene.robots = {robot_at({-9, 6}, {-9, 6})};
  scene.moving_obstacles = {walker()};
  Simulation simulation(scene, 1);
  for (int step = 0; step < 33; ++step) simulation.step();  // at 3.3 s it is seen before its corner
  const Neighbor seen = simulation.perceive({0}).neighbors.at(0);
  EXPECT_NEAR(seen.position.x, 2.3, 1e-12);
  EXPECT_NEAR(seen.position.y, 0.0, 1e-12);
  EXPECT_EQ(seen.velocity, (Vec2{1, 0}));
}

// Within a step it goes straight: by its velocities at both ends it would swing out.
TEST(Trajectory, is_judged_on_straight_lines) {
  Scenario scene;
  scene.time_step = 1.0;
  scene.certificate = Certificate::none;
  scene.allow_broken_assumptions = true;
  scene.robots = {robot_at({10, 1.0}, {10, 1.0})};
  scene.robots[0].radius = 0.5;
  scene.robots[0].max_speed = scene.robots[0].preferred_speed = 1e-6;
  // below the robot it turns downwards at once: a cubic would pass 0.15 m above its line
  scene.moving_obstacles = {on({{0.0, {9, 0}}, {1.0, {10, 0}}, {2.0, {10, 5}}}, 0.45)};
  scene.moving_obstacles[0].trajectory[2].position = {10, -5};
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  simulation.step(), metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().mover_collisions, 0);
  simulation.step(), metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().mover_collisions, 0);
  scene.moving_obstacles[0].radius = 0.51;
  Simulation nearer(scene, 1);
  Metrics of_nearer(scene);
  of_nearer.observe(nearer);
  nearer.step(), of_nearer.observe(nearer);
  EXPECT_EQ(of_nearer.summary().mover_collisions, 1);
}

TEST(Trajectory, is_saved) {
  Scenario scene;
  scene.robots = {robot_at({-9, 0}, {9, 0})};
  scene.moving_obstacles = {walker(), on({{0.0, {3, 3}}, {9.0, {3, -3}}})};
  Simulation simulation(scene, 1);
  for (int step = 0; step < 20; ++step) simulation.step();
  Simulation other(simulation.save(), 1);
  for (int step = 0; step < 40; ++step) simulation.step(), other.step();
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
  EXPECT_EQ(other.moving_obstacles().setup[0].trajectory, scene.moving_obstacles[0].trajectory);
  scene.moving_obstacles[0].trajectory[1].position.x += 0.5;
  Simulation another(scene, 1);
  another.restore(simulation.save());  // moving obstacles come and go
  EXPECT_EQ(another.moving_obstacles().setup[0].trajectory,
            other.moving_obstacles().setup[0].trajectory);
  EXPECT_EQ(another.state_hash(), simulation.state_hash());
}

TEST(Trajectory, that_nobody_can_follow_is_refused) {
  Scenario scene;
  scene.robots = {robot_at({-9, 0}, {9, 0})};
  const auto refused = [&](const MovingObstacle& obstacle) {
    scene.moving_obstacles = {obstacle};
    return refusal(scene);
  };
  EXPECT_EQ(refused(walker()), "");
  const std::string here = "moving_obstacles.0.";
  EXPECT_EQ(refused(on({{1.0, {0, 0}}, {1.0, {2, 0}}})),
            here + "trajectory: found 1 s after 1 s, must be ascending times");
  EXPECT_TRUE(refused(on({{1.0, {0, 0}}, {2.0, {std::nan(""), 0}}}))
                  .starts_with(here + "trajectory.0: found nan"));
  MovingObstacle obstacle = walker();
  obstacle.position.x = 1.0;
  EXPECT_EQ(refused(obstacle),
            here + "position: found [1, 0], must be [0, 0], where its trajectory has it at 0 s");
  obstacle = walker();
  obstacle.path = {{1, 1}};
  obstacle.max_deviation = 1.0, obstacle.max_speed = 5.0;
  EXPECT_EQ(refused(obstacle), here + "path: found one, must be left out beside a trajectory");
  obstacle.path.clear();
  EXPECT_EQ(refused(obstacle), "");
  obstacle.max_speed = 1.5;
  EXPECT_EQ(refused(obstacle),
            here + "max_speed: found 1.5, must be >= 2 m/s, what its trajectory has");
  obstacle.max_speed.reset(), obstacle.acceleration = {0, 1};
  EXPECT_EQ(refused(obstacle),
            here + "acceleration: found [0, 1], must be [0, 0] beside a trajectory");
}

// A moving obstacle that comes fast later has to be seen from far away at once.
TEST(Trajectory, counts_at_its_fastest_for_how_far_robots_sense) {
  Scenario scene;
  scene.robots = {robot_at({-9, 0}, {9, 0})};
  scene.moving_obstacles = {on({{0.0, {5, 5}}, {9.0, {5, 4}}})};
  const double slow = needed_sensing_radius(scene);
  scene.moving_obstacles = {on({{0.0, {5, 5}}, {9.0, {5, 4}}, {10.0, {5, -4}}})};
  EXPECT_GT(needed_sensing_radius(scene), slow + 5.0);
}

// The moving obstacle stands on the course of the robot until it leaves, and is evaded on its path.
TEST(Trajectory, is_evaded) {
  for (int k = 0; k < 20; ++k) {
    Scenario scene;
    const double offset = 0.05 * k - 0.5;
    scene.robots = {robot_at({-9, 0}, {9, 0})};
    scene.moving_obstacles = {on({{0.0, {6, offset}}, {2.0, {6, offset}}, {12.0, {-9, offset}}}),
                              on({{1.0, {1, 9}}, {9.0, {1, -9}}})};
    Simulation simulation(scene, 1);
    Metrics metrics(scene);
    metrics.observe(simulation);
    for (int step = 0; step < 250; ++step) simulation.step(), metrics.observe(simulation);
    EXPECT_EQ(metrics.summary().mover_collisions, 0) << k;
    EXPECT_TRUE(simulation.all_at_goal()) << k;
  }
}

}  // namespace
}  // namespace avo
