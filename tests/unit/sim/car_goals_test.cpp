// SPDX-License-Identifier: Apache-2.0
// Cars that cannot turn in place come to goals wherever these are, and stay there.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"
#include "support/generators.h"

namespace avo::test {
namespace {

struct Reached {
  int inside = 0;      // goals inside the turning circle at the start
  int missing = 0;     // after the time
  double speed = 0.0;  // m/s, the highest one at the end
};

// Each by itself, goals within three times the radius of its turning circle.
Reached reached_by(const Car& car, double radius) {
  Random random(7);
  Scenario scene;
  scene.arrival_distance = 0.1;
  Reached reached;
  const double turning = 1.0 / car.max_curvature.value_or(0.5);
  for (int k = 0; k < 100; ++k) {
    RobotSetup robot;
    robot.radius = radius;
    robot.position = {60.0 * (k % 10), 60.0 * static_cast<double>(k / 10)};
    robot.goal = robot.position + in_disc(random, 3.0 * turning);
    robot.model = car;
    robot.heading = random.uniform(-3.0, 3.0);
    const Vec2 way = robot.goal - robot.position;
    const double across = std::abs(cross({std::cos(robot.heading), std::sin(robot.heading)}, way));
    reached.inside += norm_squared(way) < 2.0 * turning * across ? 1 : 0;
    scene.robots.push_back(robot);
  }
  Simulation simulation(scene, 1);
  while (simulation.time() < 60.0) simulation.step();
  for (std::size_t k = 0; k < 100; ++k) {
    reached.missing += simulation.is_at_goal(k) ? 0 : 1;
    reached.speed = std::max(reached.speed, norm(simulation.fleet().velocity[k]));
  }
  return reached;
}

TEST(CarGoals, inside_the_turning_circle_are_reached) {
  for (const bool reverse : {false, true}) {
    for (const double offset : {0.0, 0.5, -0.4}) {
      for (const AccelerationSet set : {AccelerationSet::incircle, AccelerationSet::exact}) {
        SCOPED_TRACE(testing::Message() << reverse << ' ' << offset << ' ' << to_string(set));
        const Car car{1.0, 0.8, CarBody{offset, 0.9}, reverse, set};
        const Reached reached = reached_by(car, 0.9);
        EXPECT_GT(reached.inside, 20);
        EXPECT_EQ(reached.missing, 0);
        EXPECT_LT(reached.speed, 1e-3);
      }
    }
  }
}

TEST(CarGoals, a_car_that_turns_in_place_reaches_them_with_its_disc_ahead) {
  const Reached reached = reached_by({.body = CarBody{0.4, 0.9}}, 0.9);
  EXPECT_EQ(reached.missing, 0);
}

TEST(CarGoals, reverse_saves_a_way_round) {
  const auto time_of = [](bool reverse) {
    Scenario scene;
    RobotSetup robot;
    robot.goal = {-6, 0};
    robot.model = Car{.max_curvature = 0.5, .reverse = reverse};
    scene.robots = {robot};
    Simulation simulation(scene, 1);
    while (simulation.time() < 60.0 && !simulation.all_at_goal()) simulation.step();
    return simulation.time();
  };
  EXPECT_LT(time_of(true), 6.0);
  EXPECT_GT(time_of(false), 6.0);
  EXPECT_LT(time_of(false), 20.0);
}

}  // namespace
}  // namespace avo::test
