// SPDX-License-Identifier: Apache-2.0
// The crush has robots of all kinds. The robots are unequal, cars are among them, and priorities
// give shares of 1/64 to 63/64. The limits of braking are 0.5 to 3 of the robots' a_max. There are
// one-sided layers, and people do as they like. All of them are sent to one point after the other.
// Check judges the runs.
#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "property/crushes.h"

namespace avo::test {
namespace {

constexpr int kRobots = 60, kPeople = 5;
constexpr int kRally = 50;        // steps
constexpr double kExtent = 14.0;  // m

// One robot in six is a car, and one is a drive. One robot in six is a car with the exact set and a
// body ahead of its axle or behind it. One robot in six is in a layer that the other robots avoid,
// and it avoids none of the other robots.
RobotSetup any_robot(Random& random) {
  RobotSetup robot;
  robot.radius = random.uniform(0.2, 0.4);
  robot.position = in_square(random, kExtent);
  robot.max_acceleration = random.uniform(0.5, 2.0);
  robot.max_braking = random.log_uniform(0.5, 3.0) * robot.max_acceleration;
  robot.max_speed = robot.preferred_speed = 1.5;
  robot.priority = random.log_uniform(1e-3, 1e3);
  robot.heading = random.uniform(-3.0, 3.0);
  const int kind = random.below(6);
  if (kind == 0) robot.model = Car{0.3};
  if (kind == 1) robot.layers.bits = robot.avoids.bits = 2;
  if (kind == 2) {
    const double most = std::max(robot.max_acceleration, *robot.max_braking);
    robot.model = DifferentialDrive{0.2, 0.1, 1.5, 4.0 * most};
    robot.radius -= 0.1;
  }
  if (kind == 3) {
    const CarBody body{random.uniform(-0.4, 0.4), robot.radius};
    robot.model =
        Car{0.4, random.uniform(0.5, 3.0), body, random.below(2) == 0, AccelerationSet::exact};
  }
  return robot;
}

Scenario crush(Random& random) {
  Scenario scene;
  scene.sensing_radius = 40.0;
  scene.max_neighbors = 10;
  while (scene.robots.size() < kRobots) {
    const RobotSetup robot = any_robot(random);
    if (is_clear(robot, scene.robots)) scene.robots.push_back(robot);
  }
  for (int k = 0; k < kPeople; ++k) {
    MovingObstacle person;
    const double top = random.uniform(0.5, 1.5);
    person.position = (0.5 * kExtent + 6.0) * random.direction();
    person.radius = 0.25;
    person.max_deviation = random.uniform(0.5, 3.0);
    person.max_speed = top;
    for (int point = 0; point < 6; ++point) person.path.push_back(in_square(random, kExtent));
    scene.moving_obstacles.push_back(person);
  }
  return scene;
}

TEST(MixedCrush, nobody_touches_anybody_but_at_rest) {
  Random random(3);
  const Scenario scene = crush(random);
  Simulation simulation(scene, 1);
  Check check = judge_of(scene);
  observe(simulation, check);
  for (int step = 0; step < 700; ++step) {
    if (step % kRally == 0) {
      const Vec2 rally = in_square(random, 0.5 * kExtent);
      for (std::size_t k = 0; k < scene.robots.size(); ++k) simulation.set_goal({k}, rally);
    }
    simulation.step();
    observe(simulation, check);
  }
  const CheckReport report = check.report();
  EXPECT_EQ(report.overlaps.count, 0) << "deepest " << report.overlaps.worst;
  EXPECT_EQ(report.mover_contacts_moving.count, 0) << report.mover_contacts_moving.worst;
  EXPECT_EQ(report.one_sided_contacts_moving.count, 0) << report.one_sided_contacts_moving.worst;
  EXPECT_EQ(report.accelerations.count, 0) << "by up to " << report.accelerations.worst;
  EXPECT_EQ(report.speeds.count, 0);
  EXPECT_EQ(report.jumps.count, 0);
  EXPECT_GT(report.mover_contacts_at_rest, 35);
  EXPECT_GT(report.one_sided_contacts_at_rest, 35);
  ASSERT_TRUE(report.least_clearance);
  EXPECT_LT(*report.least_clearance, 0.02);  // it was tight
  EXPECT_GT(report.largest_speed, 1.0);      // and fast
}

}  // namespace
}  // namespace avo::test
