// SPDX-License-Identifier: Apache-2.0
// A robot that shares its goal with others stands once it is within the arrival distance.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "avo/simulation.h"
#include "perceived.h"
#include "scenes.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::robot_at;

double distance_to_goal(const Simulation& simulation, std::size_t robot) {
  const FleetView fleet = simulation.fleet();
  return norm(fleet.goal[robot] - fleet.position[robot]);
}

// One that is near the goal at 30 s, and so slow that it can stand long before it is there; and
// another one that is far away.
Scenario far_and_near() {
  Scenario scene;
  scene.robots = {robot_at({-8, 0}, {0, 0}), robot_at({0, 900}, {0, 0})};
  scene.robots[0].preferred_speed = 0.5;
  return scene;
}

void run(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

TEST(SharedGoals, who_is_near_enough_brakes_and_stands) {
  Simulation simulation(far_and_near(), 1);
  run(simulation, 300);
  const double distance = distance_to_goal(simulation, 0);
  EXPECT_GT(distance, 0.1);
  EXPECT_LT(distance, 0.5);
  EXPECT_EQ(simulation.fleet().velocity[0], Vec2{});
  EXPECT_TRUE(simulation.is_at_goal({0}));
}

// What it has done, and not what it had chosen before it was stopped.
TEST(SharedGoals, robots_remember_the_acceleration_of_their_stop) {
  Scenario scene = far_and_near();
  scene.robots.push_back(robot_at({-8, 1.05}, {8, 1.05}));  // it would push the first one
  scene.robots[2].preferred_speed = 0.5;
  Simulation simulation(scene, 1);
  double most = 0.0;  // m/s², of braking near the goal
  for (int k = 0; k < 300; ++k) {
    simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(fleet.detour[i].acceleration_x, static_cast<float>(fleet.plan[i].acceleration.x));
      ASSERT_EQ(fleet.detour[i].acceleration_y, static_cast<float>(fleet.plan[i].acceleration.y));
    }
    if (distance_to_goal(simulation, 0) < 0.5)
      most = std::max(most, norm(fleet.plan[0].acceleration));
  }
  EXPECT_NEAR(most, 1.0, 1e-9) << "it brakes in full";
}

TEST(SharedGoals, that_are_no_longer_shared_are_reached) {
  Simulation simulation(far_and_near(), 1);
  run(simulation, 300);
  simulation.set_goal({1}, {5, 0});
  run(simulation, 100);
  EXPECT_LT(distance_to_goal(simulation, 0), 1e-9);
  simulation.set_goal({1}, {0, 0});  // and it stays there
  run(simulation, 10);
  EXPECT_LT(distance_to_goal(simulation, 0), 1e-9);

  Simulation left(far_and_near(), 1);
  run(left, 300);
  left.remove_robot({1});
  run(left, 100);
  EXPECT_LT(distance_to_goal(left, 0), 1e-9);
}

// Robots that may be in one place do not share a point at which only one can be.
TEST(SharedGoals, are_those_of_robots_that_keep_apart) {
  struct Case {
    LayerSet layers, avoids;
    bool stands;
  };
  for (const Case& other :
       {Case{{2}, {2}, false}, Case{{2}, {3}, true}, Case{{3}, {2}, true}, Case{{1}, {2}, true}}) {
    SCOPED_TRACE(testing::Message() << other.layers.bits << ' ' << other.avoids.bits);
    Scenario scene = far_and_near();
    scene.robots[0].layers = {1}, scene.robots[0].avoids = {1};
    scene.robots[1].layers = other.layers, scene.robots[1].avoids = other.avoids;
    Simulation simulation(scene, 1);
    run(simulation, 400);
    if (other.stands) {
      EXPECT_GT(distance_to_goal(simulation, 0), 0.1);
    } else {
      EXPECT_LT(distance_to_goal(simulation, 0), 1e-9);
    }
  }
}

// Two of three robots keep apart; the third one is in a layer of its own.
TEST(SharedGoals, are_told_one_by_one) {
  Scenario scene = far_and_near();
  scene.robots.push_back(robot_at({900, 0}, {0, 0}));
  scene.robots[0].layers = scene.robots[0].avoids = {4};
  scene.robots[1].avoids = scene.robots[2].avoids = {1};
  Simulation alone(scene, 1);
  run(alone, 400);
  EXPECT_LT(distance_to_goal(alone, 0), 1e-9);
  scene.robots[2].layers = {4};
  Simulation shared(scene, 1);
  run(shared, 400);
  EXPECT_GT(distance_to_goal(shared, 0), 0.1);
}

TEST(SharedGoals, of_robots_that_come_later_count_as_well) {
  Scenario scene = far_and_near();
  scene.robots.pop_back();
  Simulation simulation(scene, 1);
  simulation.add_robot(robot_at({0, 900}, {0, 0}));
  run(simulation, 300);
  EXPECT_GT(distance_to_goal(simulation, 0), 0.1);
}

TEST(SharedGoals, are_perceived_as_they_are_stepped_and_restored) {
  Simulation simulation(far_and_near(), 1);
  int stops = 0;
  for (int k = 0; k < 300; ++k) {
    const Simulation::Perception seen = simulation.perceive({0});
    Detour detour = seen.detour;
    PlanWorkspace workspace;
    const Plan planned =
        simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
    stops += seen.stop ? 1 : 0;
    simulation.step();
    const Plan plan = seen.stop.value_or(planned);
    ASSERT_EQ(simulation.fleet().plan[0].next_velocity, plan.next_velocity) << k;
  }
  EXPECT_GE(stops, 5);
  Simulation restored(simulation.save(), 1);
  run(simulation, 50), run(restored, 50);
  EXPECT_EQ(simulation.state_hash(), restored.state_hash());
}

// Robot 1 finds no room at the goal that it shares, and rests beside it, on the goal of robot 2.
Scenario on_a_third_goal() {
  Scenario scene;
  scene.robots = {robot_at({-6, 0}, {0, 0}), robot_at({9, 0}, {0.1, 0}),
                  robot_at({40, 0}, {1.4, 0})};
  scene.arrival_distance = 0.05;
  return scene;
}

TEST(SharedGoals, are_those_on_which_robots_rest_that_had_no_room) {
  Simulation simulation(on_a_third_goal(), 1);
  run(simulation, 400);
  ASSERT_LT(norm(simulation.fleet().position[1] - Vec2{1.4, 0}), 1.0);
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_EQ(simulation.fleet().velocity[2], Vec2{});
  EXPECT_GT(distance_to_goal(simulation, 2), 0.4) << "robot 1 rests there";
  simulation.set_goal({1}, {0, 20});
  run(simulation, 250);
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_LT(distance_to_goal(simulation, 2), 1e-9) << "robot 1 has left";
}

TEST(SharedGoals, that_are_taken_are_restored) {
  for (const Clock clock : {Clock::common, Clock::free}) {
    Scenario scene = on_a_third_goal();
    scene.clock = clock;
    if (clock == Clock::free) scene.robots[1].time_step = 0.07;
    Simulation simulation(scene, 1);
    while (simulation.time() < 23.0) {
      Simulation restored(simulation.save(), 1);
      run(simulation, 7), run(restored, 7);
      ASSERT_EQ(simulation.state_hash(), restored.state_hash()) << simulation.time();
    }
    while (simulation.time() < 40.0) simulation.step();
    EXPECT_TRUE(simulation.all_at_goal());
  }
}

// Goals at random in a square of 4 m: robots rest on the goals of others.
TEST(SharedGoals, differ_and_overlap) {
  for (const std::uint64_t seed : {8U, 9U, 16U, 19U, 20U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    Scenario scene;
    while (scene.robots.size() < 12) {
      const Vec2 from{random.uniform(-15, 15), random.uniform(-15, 15)};
      const bool is_free =
          std::all_of(scene.robots.begin(), scene.robots.end(),
                      [&](const RobotSetup& other) { return norm(other.position - from) > 1.3; });
      const Vec2 goal{random.uniform(-2, 2), random.uniform(-2, 2)};
      if (norm(from) > 4.0 && is_free) scene.robots.push_back(robot_at(from, goal));
    }
    Simulation simulation(scene, 1);
    run(simulation, 600);
    EXPECT_TRUE(simulation.all_at_goal());
  }
}

TEST(SharedGoals, make_a_crowd_come_to_rest) {
  Scenario scene;
  scene.arrival_distance = 1.5;
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3.0 + 0.1 * k;
    RobotSetup robot = robot_at(10.0 * Vec2{std::cos(angle), std::sin(angle)}, {});
    robot.radius = 0.3;
    scene.robots.push_back(robot);
  }
  Simulation simulation(scene, 1);
  run(simulation, 600);
  EXPECT_TRUE(simulation.all_at_goal());
  for (const Vec2 velocity : simulation.fleet().velocity) EXPECT_EQ(velocity, Vec2{});
}

// The methods to compare with are what they are.
TEST(SharedGoals, are_minded_by_method_avo_alone) {
  for (const Method method : {Method::orca, Method::velocity_obstacle, Method::avo_paper}) {
    Scenario scene = far_and_near();
    scene.method = method;
    Simulation simulation(scene, 1);
    for (int k = 0; k < 400; ++k) {
      EXPECT_FALSE(simulation.perceive({0}).stop) << to_string(method);
      simulation.step();
      ASSERT_LE(norm(simulation.fleet().velocity[0]), 0.5 + 1e-9) << to_string(method);
    }
  }
}

// A robot that senses moving obstacles alone is planned apart from the others. The robot that stops
// is the right one.
TEST(SharedGoals, stop_those_who_share_them_beside_robots_among_movers) {
  Scenario scene = far_and_near();
  scene.robots.insert(scene.robots.begin(), robot_at({200, 0}, {230, 0}));
  scene.robots.insert(scene.robots.begin() + 2, robot_at({200, 400}, {230, 400}));
  scene.moving_obstacles = {{.position = {205, 2}}, {.position = {204, 403}}};
  Simulation simulation(scene, 1);
  int stops = 0;
  const auto count = [&](const Simulation::Perception& seen) { stops += seen.stop ? 1 : 0; };
  for (int k = 0; k < 300; ++k) {
    ASSERT_NO_FATAL_FAILURE(test::step_as_perceived(simulation, count));
  }
  EXPECT_GE(stops, 3);
}

}  // namespace
}  // namespace avo
