// SPDX-License-Identifier: Apache-2.0
// Where clocks are free, a robot that decides looks at those near it, and no other robot is moved.
// The result is that of moving every robot at every instant.
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>

#include "avo/simulation.h"
#include "sim/clocks.h"
#include "sim/world.h"
#include "unit/sim/scenes.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::Random;
using test::robot_at;

// Robots of mixed time steps, that head for each other's places.
Scenario crowd(int robots, std::uint64_t seed = 1) {
  Scenario scene = test::dense_avo_scene(robots, Motion::held, Certificate::braking_trajectories);
  scene.moving_obstacles.clear();
  scene.clock = Clock::free;
  scene.seed = seed;
  for (std::size_t i = 0; i < scene.robots.size(); i += 3) scene.robots[i].time_step = 0.04;
  return scene;
}

// A simulation that is made anew at every instant, which moves and files everybody.
void expect_same_when_restored(const Scenario& scene, double duration) {
  Simulation near(scene, 1), anew(scene, 1);
  while (near.can_step_by(duration)) {
    near.step();
    ASSERT_TRUE(anew.can_step_by(duration));
    anew.restore(anew.save());
    anew.step();
    if (near.steps() % 64 == 0) {
      ASSERT_EQ(near.state_hash(), anew.state_hash()) << near.time();
    }
  }
  EXPECT_GT(near.steps(), 200);
  EXPECT_EQ(near.state_hash(), anew.state_hash());
}

TEST(FreeSteps, are_the_same_as_if_all_were_moved) {
  expect_same_when_restored(crowd(80), 3.0);
}

// They are filed again before cells are laid out anew, and far from the cell of the origin.
TEST(FreeSteps, are_the_same_of_a_few) {
  constexpr int kRobots = 10;
  Scenario scene = crowd(kRobots);
  for (int i = 0; i < kRobots; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRobots;
    const Vec2 away{12.0 * std::cos(angle), 12.0 * std::sin(angle)}, middle{100.0, 60.0};
    scene.robots[static_cast<std::size_t>(i)] = robot_at(middle + away, middle - away);
  }
  scene.sensing_radius = 8.0;
  expect_same_when_restored(scene, 15.0);
}

TEST(FreeSteps, are_the_same_where_robots_sense_all_that_are_near) {
  Scenario scene = crowd(40);
  scene.max_neighbors.reset();
  expect_same_when_restored(scene, 2.0);
  scene.sensing_radius = 3.0;  // less than a cell
  scene.certificate = Certificate::none;
  expect_same_when_restored(scene, 2.0);
}

TEST(FreeSteps, are_the_same_of_cars_and_drives) {
  Scenario scene = crowd(40);
  scene.sensing_error.reset();
  for (std::size_t i = 0; i < scene.robots.size(); i += 2) {
    RobotSetup& robot = scene.robots[i];
    robot.velocity = {};
    robot.model = i % 4 == 0 ? MotionModel(Car{.wheelbase = 0.5, .body = CarBody{0.2, 0.5}})
                             : MotionModel(DifferentialDrive{});
    if (i % 4 != 0) robot.max_acceleration = 0.9 * most_acceleration(DifferentialDrive{});
    if (i % 4 != 0) robot.max_speed = robot.preferred_speed = 0.5;
  }
  expect_same_when_restored(scene, 2.0);
}

TEST(FreeSteps, are_the_same_of_robots_that_are_not_alike) {
  Scenario scene = crowd(60);
  scene.robots[5].priority = 3.0;
  scene.robots[7].layers = LayerSet{2}, scene.robots[7].avoids = LayerSet{1};
  scene.robots[9].max_braking = 1.7 * scene.robots[9].max_acceleration;
  RobotSetup& parked = scene.robots[11];
  parked.behavior = Behavior::parked, parked.time_step.reset();
  parked.velocity = {}, parked.goal = parked.position;
  expect_same_when_restored(scene, 2.0);
}

TEST(FreeSteps, are_the_same_among_moving_obstacles) {
  Scenario scene = crowd(40);
  scene.moving_obstacles = {{{-3.1, 4.3}, {1.1, 0.2}, {}, 0.7},
                            {{9.9, -2.2}, {0.05, 1.3}, {}, 0.6}};
  expect_same_when_restored(scene, 2.0);
}

TEST(FreeSteps, are_the_same_of_every_method) {
  for (const Method method :
       {Method::orca, Method::velocity_obstacle, Method::buffered_voronoi, Method::avo_paper}) {
    Scenario scene = crowd(40);
    scene.method = method;
    scene.certificate.reset();
    scene.max_neighbors = 8;
    expect_same_when_restored(scene, 1.0);
  }
}

// At every instant the simulation knows which robots are faster than their limits.
TEST(FreeSteps, are_the_same_where_some_are_too_fast) {
  Scenario scene = crowd(60);
  for (std::size_t i = 0; i < scene.robots.size(); i += 7) {
    RobotSetup& robot = scene.robots[i];
    robot.velocity = (1.4 * robot.max_speed / norm(robot.velocity)) * robot.velocity;
  }
  expect_same_when_restored(scene, 2.0);
}

TEST(FreeSteps, are_the_same_among_walls_and_with_noise) {
  Scenario scene = crowd(30);
  scene.obstacles = {{{{{{-4.0, -4.0}, {14.0, -4.0}}, false}}, 0.1, Fill::none}};
  expect_same_when_restored(scene, 1.0);
  scene.obstacles.clear();
  scene.sensing.noise.position = 0.01;
  expect_same_when_restored(scene, 1.0);
}

// Looks and edits between steps, some of one robot alone.
TEST(FreeSteps, are_the_same_whoever_looks_and_whatever_is_edited) {
  const Scenario scene = crowd(50);
  Simulation watched(scene, 1), alone(scene, 1);
  Random random(5);
  for (int k = 0; k < 1500; ++k) {
    const auto i = static_cast<std::size_t>(random.uniform(0.0, 50.0));
    const RobotState state = watched.robot({i});
    const RobotSetup setup = watched.setup({i});
    const bool at_goal = watched.is_at_goal({i});
    const double left = watched.route({i}).length;
    if (k % 3 == 0) {
      const FleetView fleet = watched.fleet();
      ASSERT_EQ(state.position, fleet.position[i]);
      ASSERT_EQ(state.velocity, fleet.velocity[i]);
      ASSERT_EQ(setup, fleet.setup[i]);
      ASSERT_EQ(at_goal, watched.is_at_goal({i}));
      ASSERT_EQ(left, watched.route({i}).length);
    }
    if (k % 5 == 0) {
      const Vec2 goal{random.uniform(0.0, 12.0), random.uniform(0.0, 12.0)};
      watched.set_goal(state.id, goal), alone.set_goal(state.id, goal);
    }
    if (k % 400 == 100) {
      const RobotSetup far = robot_at({300.0 + k, 0.0}, {});
      ASSERT_EQ(watched.add_robot(far).value, alone.add_robot(far).value);
    }
    if (k % 400 == 300)
      watched.move_robot({7}, {-100.0, 1.0 * k}), alone.move_robot({7}, {-100.0, 1.0 * k});
    watched.step(), alone.step();
  }
  EXPECT_EQ(watched.time(), alone.time());
  EXPECT_EQ(watched.state_hash(), alone.state_hash());
}

// Every robot is filed once for as many decisions as there are robots. In between, no robot is
// moved but the ones that decide.
TEST(FreeSteps, move_nobody_but_those_who_decide) {
  Scenario scene = crowd(200);
  scene.allow_broken_assumptions = true;
  World world(scene, std::make_unique<SerialExecutor>());
  int filings = 0;
  std::size_t decisions = 0, moved = 0;
  for (int k = 0; k < 3000; ++k) {
    const Instant since = world.whereabouts.since;
    const std::vector<Vec2> before = world.fleet.position;
    step(world);
    decisions += world.due.size();
    if (world.whereabouts.since != since) {
      ++filings;
      continue;
    }
    for (std::size_t slot = 0; slot < before.size(); ++slot)
      moved += before[slot] == world.fleet.position[slot] ? 0 : 1;
    EXPECT_FALSE(world.is_current);
  }
  EXPECT_LE(filings, 3 + static_cast<int>(decisions / world.fleet.size()));
  EXPECT_LE(moved, decisions);
  EXPECT_GT(moved, decisions / 2);
}

}  // namespace
}  // namespace avo
