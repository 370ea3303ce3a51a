// SPDX-License-Identifier: Apache-2.0
// Large fleets are kept in spatial order, and a caller notices nothing of it.
#include <cmath>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

#include "avo/error.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;

// Robots of unequal sizes and limits in no order, too many to be left as they are.
Scenario crowd_of(int count, Method method, double spacing = 2.5) {
  Random random(4);
  Scenario scene;
  scene.method = method;
  scene.max_neighbors = 10;
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int k = 0; k < count; ++k) {
    const int place = static_cast<int>((static_cast<std::int64_t>(k) * 7919) % (side * side));
    RobotSetup robot;
    const double x = spacing * (place % side + 0.2 * random.uniform(0.0, 1.0));
    robot.position = {x, spacing * (place / side + 0.2 * random.uniform(0.0, 1.0))};
    const double goal = random.uniform(0.0, spacing * side);
    robot.goal = {goal, random.uniform(0.0, spacing * side)};
    robot.radius = random.uniform(0.3, 0.5);
    robot.max_speed = random.uniform(1.0, 2.0);
    robot.max_acceleration = random.uniform(0.8, 2.0);
    scene.robots.push_back(robot);
  }
  scene.moving_obstacles = {{{-3.0, 10.0}, {1.0, 0.0}, {}, 0.6}};
  return scene;
}

constexpr int kOrdered = 1100;

// Every decision is that of the planner on what the robot perceives, found by comparing all.
void expect_decisions_on_perceptions(const Scenario& scene, int steps) {
  Simulation simulation(scene, 3);
  PlanWorkspace workspace;
  for (int k = 0; k < steps; ++k) {
    const auto first = static_cast<std::size_t>(k % 7);
    std::vector<Plan> expected;
    for (std::size_t i = first; i < scene.robots.size(); i += 7) {
      const Simulation::Perception seen = simulation.perceive({i});
      Detour detour = seen.detour;
      expected.push_back(simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour));
    }
    simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = first, next = 0; i < scene.robots.size(); i += 7) {
      ASSERT_EQ(fleet.plan[i].new_velocity, expected[next++].new_velocity) << i << " step " << k;
    }
  }
}

TEST(SpatialOrder, every_robot_decides_on_what_it_perceives) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    expect_decisions_on_perceptions(crowd_of(kOrdered, method), 40);
  }
}

// A robot that is faster than it may be is dangerous from farther away.
TEST(SpatialOrder, the_fast_are_seen_by_all) {
  Random random(6);
  Scenario scene = crowd_of(100, Method::avo, 12.0);
  scene.max_neighbors = 1;
  scene.sensing_radius = 60.0;
  scene.allow_broken_assumptions = true;
  for (RobotSetup& robot : scene.robots) {
    if (random.below(4) == 0) robot.velocity = 8.0 * random.direction();
  }
  expect_decisions_on_perceptions(scene, 40);
}

TEST(SpatialOrder, any_number_of_threads_gives_the_same_bits) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    std::vector<std::uint64_t> one;
    for (const int threads : {1, 2, 3, 7}) {
      Simulation simulation(crowd_of(kOrdered, method), threads);
      for (std::size_t k = 0; k < 40; ++k) {
        simulation.step();
        if (threads == 1) one.push_back(simulation.state_hash());
        ASSERT_EQ(simulation.state_hash(), one[k]) << threads << " threads, step " << k;
      }
    }
  }
}

// The small fleet stays in its order. The large one has the same robots among others that are far
// away, too many to stay in theirs.
TEST(SpatialOrder, changes_no_bit) {
  const int few = 300;
  const Scenario small = crowd_of(few, Method::avo);
  Scenario large = small;
  for (RobotSetup robot : crowd_of(kOrdered, Method::avo).robots) {
    robot.position = robot.position + Vec2{2000.0, -700.0};
    robot.goal = robot.goal + Vec2{2000.0, -700.0};
    large.robots.push_back(robot);
  }
  Simulation a(small, 2), b(large, 2);
  for (int k = 0; k < 60; ++k) {
    a.step();
    b.step();
    for (std::size_t i = 0; i < few; ++i) {
      ASSERT_EQ(a.fleet().position[i], b.fleet().position[i]) << i << " step " << k;
      ASSERT_EQ(a.fleet().velocity[i], b.fleet().velocity[i]);
      ASSERT_EQ(a.fleet().detour[i].angle, b.fleet().detour[i].angle);
    }
  }
}

TEST(SpatialOrder, robots_are_known_by_their_ids) {
  const Scenario scene = crowd_of(kOrdered, Method::avo_paper);
  Simulation simulation(scene, 1);
  for (int k = 0; k < 20; ++k) simulation.step();
  const Vec2 goal{-5.0, 3.0};
  simulation.set_goal({17}, goal);
  const Vec2 before = simulation.fleet().position[500];
  simulation.remove_robot({3});
  simulation.remove_robot({1099});
  EXPECT_THROW(simulation.remove_robot({3}), Error);
  RobotSetup last = scene.robots[0];
  last.position = {-50.0, -50.0};
  EXPECT_EQ(simulation.add_robot(last).value, 1100u);
  for (int k = 0; k < 2; ++k) {
    const FleetView fleet = simulation.fleet();
    ASSERT_EQ(fleet.id.size(), 1099u);
    for (std::size_t i = 1; i < fleet.id.size(); ++i) {
      ASSERT_LT(fleet.id[i - 1].value, fleet.id[i].value);
    }
    EXPECT_EQ(fleet.id[16].value, 17u);
    EXPECT_EQ(fleet.goal[16], goal);
    for (std::size_t i = 0; i + 1 < fleet.id.size(); ++i) {
      const RobotSetup& given = scene.robots[fleet.id[i].value];
      ASSERT_EQ(fleet.setup[i].radius, given.radius);
      ASSERT_EQ(fleet.setup[i].max_acceleration, given.max_acceleration);
    }
    EXPECT_EQ(fleet.setup[1098].radius, last.radius);
    if (k == 0) {
      EXPECT_EQ(fleet.position[499], before);
      for (int more = 0; more < 20; ++more) simulation.step();
    }
  }
}

TEST(SpatialOrder, a_fleet_may_be_looked_at_by_many_at_once) {
  Simulation simulation(crowd_of(kOrdered, Method::avo_paper), 1);
  for (int k = 0; k < 18; ++k) simulation.step();
  std::vector<FleetView> views(4);
  std::vector<std::thread> lookers;
  for (FleetView& view : views) {
    lookers.emplace_back([&] { view = simulation.fleet(); });
  }
  for (std::thread& looker : lookers) looker.join();
  for (const FleetView& view : views) {
    EXPECT_EQ(view.position.data(), views[0].position.data());
    EXPECT_EQ(view.id[700].value, 700u);
  }
}

// All robots are in one cell, or all in one place. The work is bounded, and no robot is lost.
TEST(SpatialOrder, degenerate_crowds) {
  for (const double spacing : {1e-3, 0.0}) {
    Scenario scene = crowd_of(kOrdered, Method::avo_paper, spacing);
    Simulation simulation(scene, 2), serial(scene, 1);
    for (int k = 0; k < 3; ++k) simulation.step(), serial.step();
    EXPECT_EQ(simulation.state_hash(), serial.state_hash());
    EXPECT_EQ(simulation.fleet().id.size(), static_cast<std::size_t>(kOrdered));
  }
  Scenario scene = crowd_of(1, Method::avo_paper);
  scene.robots.assign(20000, scene.robots[0]);
  Simulation simulation(scene, 2);
  EXPECT_EQ(simulation.perceive({19999}).source[0], 0);
  simulation.step();  // and they part
  EXPECT_NE(simulation.fleet().position[0], simulation.fleet().position[19999]);
}

}  // namespace
}  // namespace avo
