// SPDX-License-Identifier: Apache-2.0
// Cars that cannot turn in place come to goals wherever these are, and stay there.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>
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
    reached.missing += simulation.is_at_goal({k}) ? 0 : 1;
    reached.speed = std::max(reached.speed, norm(simulation.fleet().velocity[k]));
  }
  return reached;
}

// How many of the robots of a scene arrive.
int arrived_within(const Scenario& scene, double time) {
  Simulation simulation(scene, 1);
  while (simulation.time() < time && !simulation.all_at_goal()) simulation.step();
  int arrived = 0;
  for (std::size_t k = 0; k < scene.robots.size(); ++k)
    arrived += simulation.is_at_goal({k}) ? 1 : 0;
  return arrived;
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

// At constant speed it cannot stay on its turning circle: its disc would come farther than others
// expect.
TEST(CarGoals, are_reached_with_a_body_farther_off_the_axle_than_the_turning_circle) {
  for (const bool reverse : {false, true}) {
    for (const auto& [curvature, offset] :
         {std::pair{2.0, 0.8}, std::pair{1.0, 1.5}, std::pair{1.0, -1.5}, std::pair{0.8, 3.0}}) {
      SCOPED_TRACE(testing::Message() << reverse << ' ' << curvature << ' ' << offset);
      const Car car{1.0, curvature, CarBody{offset, std::abs(offset) + 0.3}, reverse};
      const Reached reached = reached_by(car, 0.3);
      EXPECT_EQ(reached.missing, 0);
      EXPECT_LT(reached.speed, 1e-3);
    }
  }
}

// The car must not come round too fast to stop, pass its goal and drive the same course again, for
// ever.
TEST(CarGoals, a_car_that_comes_to_its_goal_out_of_a_turn_stops_there) {
  Scenario scene;
  scene.arrival_distance = 0.1;
  RobotSetup robot;
  robot.goal = {0.2558, -2.016};
  robot.heading = 0.5649;
  robot.max_acceleration = 1.08, robot.max_speed = robot.preferred_speed = 2.7;
  robot.model = Car{.max_curvature = 0.3305, .body = CarBody{2.43, 2.73}};
  scene.robots = {robot};
  Simulation simulation(scene, 1);
  while (simulation.time() < 60.0) simulation.step();
  EXPECT_LT(norm(simulation.fleet().position[0] - robot.goal), 0.05);
  EXPECT_EQ(simulation.fleet().velocity[0], Vec2{});
}

// While it speeds up it turns on a wider circle: from too near it shuttled to and fro for ever.
TEST(CarGoals, a_car_whose_body_is_far_behind_backs_off_far_enough) {
  Scenario scene;
  RobotSetup robot;
  robot.goal = {0.2662, 0.5308};
  robot.heading = 2.911;
  robot.max_acceleration = 0.88;
  robot.model = Car{1.0, 0.3377, CarBody{-3.407, 3.707}, /*reverse=*/true, AccelerationSet::exact};
  scene.robots = {robot};
  scene.arrival_distance = 0.1;
  EXPECT_EQ(arrived_within(scene, 60.0), 1);
}

// A twentieth of its turning circle's radius is twice the arrival distance.
TEST(CarGoals, one_with_a_wide_turning_circle_does_not_stop_short_of_them) {
  Scenario scene;
  for (const bool reverse : {false, true}) {
    RobotSetup robot;
    robot.position = {0.0, reverse ? 200.0 : 0.0};
    robot.goal = robot.position + Vec2{0.1, 0.7};
    robot.model = Car{.max_curvature = 0.05, .reverse = reverse};
    scene.robots.push_back(robot);
  }
  Simulation simulation(scene, 1);
  while (simulation.time() < 300.0) simulation.step();
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_EQ(simulation.fleet().velocity[0], Vec2{});
  EXPECT_EQ(simulation.fleet().velocity[1], Vec2{});
}

TEST(CarGoals, a_car_that_turns_in_place_reaches_them_with_its_disc_ahead) {
  const Reached reached = reached_by({.body = CarBody{0.4, 0.9}}, 0.9);
  EXPECT_EQ(reached.missing, 0);
}

// Turns on the spot of a car at rest that is nearer to its goal than a hundredth of its radius.
int turns_at_goals(Simulation& simulation, double duration) {
  int turns = 0;
  while (simulation.time() < duration) {
    const FleetView before = simulation.fleet();
    const std::vector<double> heading(before.heading.begin(), before.heading.end());
    std::vector<bool> is_there;
    for (std::size_t k = 0; k < heading.size(); ++k)
      is_there.push_back(before.velocity[k] == Vec2{} &&
                         norm(before.goal[k] - before.position[k]) < 0.01);
    simulation.step();
    for (std::size_t k = 0; k < heading.size(); ++k)
      turns += is_there[k] && simulation.fleet().heading[k] != heading[k] ? 1 : 0;
  }
  return turns;
}

// The car must not turn round on the spot for what rounding has left of its route.
TEST(CarGoals, a_car_that_turns_about_its_axle_stands_where_it_has_come_to_rest) {
  for (const Car& car : {Car{.wheelbase = 0.8}, Car{.wheelbase = 0.8, .reverse = true},
                         Car{.wheelbase = 0.8, .body = CarBody{1e-4, 1.0}}}) {
    Random random(7);
    Scenario scene;
    for (int k = 0; k < 100; ++k) {
      RobotSetup robot;
      robot.radius = 1.0;
      robot.position = {60.0 * (k % 10), 60.0 * static_cast<double>(k / 10)};
      robot.goal = robot.position + in_disc(random, 8.0);
      robot.heading = random.uniform(-3.0, 3.0);
      robot.model = car;
      scene.robots.push_back(robot);
    }
    Simulation simulation(scene, 1);
    EXPECT_EQ(turns_at_goals(simulation, 20.0), 0);
    for (std::size_t k = 0; k < 100; ++k) {
      EXPECT_EQ(simulation.fleet().velocity[k], Vec2{});
      EXPECT_LT(norm(simulation.fleet().goal[k] - simulation.fleet().position[k]), 0.01);
    }
  }
}

// What is a hundredth of its radius off its goal stays; what is farther off goes there.
TEST(CarGoals, a_hundredth_of_the_radius_is_near_enough_to_one_that_has_to_turn) {
  Scenario scene;
  for (const double off : {0.009, 0.011}) {
    RobotSetup robot;
    robot.radius = 1.0;
    robot.position = {1e4 * off, 0.0};
    robot.goal = robot.position + Vec2{0.0, off};
    robot.model = Car{};
    scene.robots.push_back(robot);
  }
  Simulation simulation(scene, 1);
  while (simulation.time() < 20.0) simulation.step();
  const FleetView fleet = simulation.fleet();
  EXPECT_EQ(fleet.heading[0], 0.0);
  EXPECT_EQ(fleet.position[0], scene.robots[0].position);
  EXPECT_LT(norm(fleet.goal[1] - fleet.position[1]), 0.005);
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

// Six cars start on a circle and stop each other in its middle.
Scenario jam(Random& random, AccelerationSet set) {
  constexpr int kCars = 6;
  Scenario scene;
  for (int k = 0; k < kCars; ++k) {
    const double angle = (k + random.uniform(-0.2, 0.2)) * (2.0 * std::numbers::pi / kCars);
    RobotSetup robot;
    robot.radius = 1.0;
    robot.position = 6.0 * Vec2{std::cos(angle), std::sin(angle)};
    robot.goal = -random.uniform(0.8, 1.2) * robot.position;
    robot.heading = random.uniform(-3.0, 3.0);
    robot.model = Car{.wheelbase = 0.8, .acceleration_set = set};
    scene.robots.push_back(robot);
  }
  return scene;
}

// A car that turned in place towards what it may not drive in then turned back again, for ever.
// Others count on its own limit of braking, so it may drive as fast as any.
TEST(CarGoals, a_weak_brake_makes_no_car_crawl) {
  for (const Car& car : {Car{.max_curvature = 0.8, .body = CarBody{0.5, 0.9}},
                         Car{.acceleration_set = AccelerationSet::exact}}) {
    Scenario scene;
    RobotSetup robot;
    robot.goal = {20.0, 0.0};
    robot.model = car, robot.max_braking = 0.4;
    scene.robots = {robot};
    Simulation simulation(scene, 1);
    while (simulation.time() < 15.0) simulation.step();
    EXPECT_TRUE(simulation.is_at_goal({0})) << simulation.fleet().position[0].x;
  }
}

TEST(CarGoals, cars_that_turn_in_place_get_out_of_jams) {
  for (const AccelerationSet set : {AccelerationSet::incircle, AccelerationSet::exact}) {
    Random random(3);
    int missing = 0;
    for (int k = 0; k < 200; ++k) missing += 6 - arrived_within(jam(random, set), 120.0);
    EXPECT_EQ(missing, 0) << to_string(set);
  }
}

RobotSetup car_at(Vec2 position, double heading, Vec2 goal, bool reverse) {
  RobotSetup robot;
  robot.position = position, robot.heading = heading, robot.goal = goal;
  robot.model = Car{1.0, 0.8, CarBody{0.5, 0.9}, reverse};
  return robot;
}

// The car's disc touches the wall, towards which the car would back along its route. The car has to
// drive off first.
TEST(CarGoals, a_car_beside_a_wall_drives_off_it_and_then_back) {
  Scenario scene;
  scene.obstacles = {{{Chain{{{-13, -7}, {-5, -7}, {-5, -2}, {-13, -2}}, true}}}};
  scene.robots = {car_at({-6.2995, -1.1675}, 3.0049, {-2.9, -6.75}, true)};
  EXPECT_EQ(arrived_within(scene, 60.0), 1);
}

// They start a meter apart. Nose to nose in contact, neither could ever leave; so may some end.
TEST(CarGoals, cars_without_reverse_hardly_end_nose_to_nose) {
  Random random(5);
  int arrived = 0;
  for (int k = 0; k < 40; ++k) {
    Scenario scene;
    scene.robots = {
        car_at({0, 0}, random.uniform(-3.0, 3.0), in_disc(random, 40.0), false),
        car_at(3.0 * random.direction(), random.uniform(-3.0, 3.0), in_disc(random, 40.0), false)};
    arrived += arrived_within(scene, 120.0);
  }
  EXPECT_GE(arrived, 72);
}

}  // namespace
}  // namespace avo::test
