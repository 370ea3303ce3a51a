// SPDX-License-Identifier: Apache-2.0
// These scenes do not say how far robots sense. The robots sense as far as they need, and so do
// those that come later.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "avo/simulation.h"
#include "support/generators.h"
#include "unit/sim/certified_scenes.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::dense_avo_scene;
using test::head_on;
using test::Kind;
using test::kKinds;
using test::Random;
using test::robot_at;

Scenario pair_of(Method method) {
  Scenario scene;
  scene.method = method;
  scene.robots = {robot_at({-9, 0}, {9, 0}), robot_at({9, 0}, {-9, 0})};
  return scene;
}

// 1 m/s² and 0.3 m, as fast as that.
RobotSetup robot_of(double max_speed, double x) {
  RobotSetup robot = robot_at({x, 0}, {x + 5.0, 0});
  robot.radius = 0.3, robot.max_speed = robot.preferred_speed = max_speed;
  return robot;
}

TEST(SensingRadius, is_what_the_method_and_the_certificate_need) {
  // 1 m + 4 m/s · 2 √(1 m / 1 m/s²); 5.4 m for braking
  EXPECT_DOUBLE_EQ(sensing_radius_of(pair_of(Method::avo)), 9.0);
  for (const Method method : {Method::avo_paper, Method::orca, Method::velocity_obstacle})
    EXPECT_DOUBLE_EQ(sensing_radius_of(pair_of(method)), 21.0);  // 1 + 10 s at 2 m/s
  Scenario scene = pair_of(Method::avo);
  for (RobotSetup& robot : scene.robots) robot.radius = 1.5;  // 7.4 m for braking
  EXPECT_DOUBLE_EQ(sensing_radius_of(scene), 3.0 + 8.0 * std::sqrt(3.0));
  Scenario among_walls = pair_of(Method::avo);
  among_walls.obstacles = {{.chains = {{{{-30.0, 8.0}, {30.0, 8.0}}}}}};
  EXPECT_DOUBLE_EQ(sensing_radius_of(among_walls), 15.0);  // 30 radii
  among_walls.right_of_way = RightOfWay::none;
  EXPECT_DOUBLE_EQ(sensing_radius_of(among_walls), 9.0);
  Scenario unequal = pair_of(Method::avo);
  unequal.robots[0].priority = 4.0;
  EXPECT_DOUBLE_EQ(sensing_radius_of(unequal), 13.0);  // 1 m + 4 m/s · τ
  unequal.robots[1].priority = 4.0;                    // as if both had 1
  EXPECT_DOUBLE_EQ(sensing_radius_of(unequal), 9.0);
  scene.sensing.delay = 40;  // 4 s more of 2 m/s each
  EXPECT_DOUBLE_EQ(sensing_radius_of(scene), sensing_need(scene)->range);
  scene.sensing_radius = 15.0;
  EXPECT_EQ(sensing_radius_of(scene), 15.0);
  EXPECT_EQ(sensing_radius_of(Scenario{}), 1.0);
}

// m: how far a robot of that priority leaves its line before five oncoming ones.
double aside(double priority, std::optional<double> sensing_radius) {
  Scenario scene;
  scene.sensing_radius = sensing_radius;
  scene.robots = {robot_at({-10, 0}, {10, 0})};
  scene.robots[0].priority = priority;
  for (const double y : {-2.75, -1.35, 0.05, 1.45, 2.85})
    scene.robots.push_back(robot_at({10, y}, {-10, y}));
  Simulation simulation(scene, 1);
  double aside = 0.0;
  while (simulation.time() < 30.0) {
    simulation.step();
    aside = std::max(aside, std::abs(simulation.fleet().position[0].y));
  }
  return aside;
}

// With the radius that is enough for equals, a robot of priority 2 goes farther aside than one
// of 1.
TEST(SensingRadius, of_robots_of_unequal_priority_is_where_more_priority_means_less_way) {
  EXPECT_GT(aside(2.0, 9.0), aside(1.0, 9.0));
  EXPECT_LT(aside(2.0, {}), 1.15 * aside(1.0, 13.0)) << "hardly more";
  EXPECT_LT(aside(16.0, {}), aside(2.0, {}));
  EXPECT_LT(aside(1e9, {}), aside(16.0, {}));
  EXPECT_NEAR(aside(16.0, {}), aside(16.0, 15.0), 2e-3) << "hardly anybody farther off matters";
}

TEST(SensingRadius, that_is_left_out_breaks_no_assumption) {
  Random random(5);
  for (const Kind& kind : kKinds) {
    for (int round = 0; round < 20; ++round) {
      Scenario scene = head_on(400.0, kind);
      scene.sensing_radius.reset();
      for (RobotSetup& robot : scene.robots) {
        robot.radius = random.uniform(0.1, 2.0);
        robot.max_speed = robot.preferred_speed = random.uniform(0.5, 4.0);
        robot.max_acceleration = random.uniform(0.5, 3.0);
        robot.velocity = {};
      }
      EXPECT_TRUE(broken_assumptions(scene).none()) << round;
      EXPECT_GE(needed_sensing_radius(scene), sensing_need(scene)->range);
    }
  }
}

TEST(SensingRadius, that_is_left_out_has_the_bits_of_the_one_that_is_named) {
  Scenario scene = dense_avo_scene(60, Motion::held, Certificate::braking_trajectories);
  scene.sensing_radius.reset();
  Simulation left_out(scene, 1);
  scene.sensing_radius = needed_sensing_radius(scene);
  Simulation named(scene, 1);
  EXPECT_EQ(left_out.sensing_radius(), *scene.sensing_radius);
  for (int k = 0; k < 50; ++k) left_out.step(), named.step();
  EXPECT_EQ(left_out.state_hash(), named.state_hash());
}

TEST(SensingRadius, grows_with_robots_that_are_added) {
  Simulation simulation(Scenario{}, 1);
  simulation.add_robot(robot_of(1.0, 0.0));
  const double small = simulation.sensing_radius();
  EXPECT_DOUBLE_EQ(small, 0.6 + 4.0 * std::sqrt(0.6));
  simulation.add_robot(robot_of(1.0, 20.0));
  EXPECT_DOUBLE_EQ(simulation.sensing_radius(), small);
  const RobotId fast = simulation.add_robot(robot_of(4.0, 40.0));
  EXPECT_DOUBLE_EQ(simulation.sensing_radius(), 24.0);  // 1.5 · 16
  simulation.remove_robot(fast);
  EXPECT_DOUBLE_EQ(simulation.sensing_radius(), 24.0);
}

TEST(SensingRadius, that_has_grown_is_saved) {
  Scenario scene;
  scene.robots = {robot_of(1.0, 0.0), robot_of(1.0, 20.0)};
  Simulation simulation(scene, 1);
  const std::vector<std::byte> before = simulation.save();
  simulation.add_robot(robot_of(3.0, 40.0));
  const std::vector<std::byte> after = simulation.save();
  const double grown = simulation.sensing_radius();
  Simulation continued(after, 1);
  EXPECT_EQ(continued.sensing_radius(), grown);
  simulation.restore(before);
  EXPECT_LT(simulation.sensing_radius(), grown);
  simulation.restore(after);
  EXPECT_EQ(simulation.sensing_radius(), grown);
  simulation.add_robot(robot_of(5.0, 90.0)), continued.add_robot(robot_of(5.0, 90.0));
  EXPECT_EQ(simulation.sensing_radius(), continued.sensing_radius());
  for (int k = 0; k < 50; ++k) simulation.step(), continued.step();
  EXPECT_EQ(simulation.state_hash(), continued.state_hash());
}

TEST(SensingRadius, that_is_named_refuses_who_needs_more) {
  Scenario scene;
  scene.sensing_radius = 2.0;
  scene.robots = {robot_of(1.0, 0.0), robot_of(1.0, 20.0)};
  Simulation simulation(scene, 1);
  EXPECT_THROW(simulation.add_robot(robot_of(4.0, 40.0)), Error);
  EXPECT_EQ(simulation.sensing_radius(), 2.0);
}

}  // namespace
}  // namespace avo
