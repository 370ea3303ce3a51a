// SPDX-License-Identifier: Apache-2.0
// Scenes of robots among obstacles that do not react: with constant velocity, or with the motion of
// people.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "placement.h"
#include "scenes.h"

namespace avo::safety {

namespace {

// m, of the square; the start distance of the obstacles
constexpr double kSide = 20.0, kFar = 24.0;

Scene in_a_square(Random& random) {
  constexpr std::size_t kRobots = 20;
  Scene scene{usual_scenario()};
  const std::vector<double> radii(kRobots, 0.5);
  const std::vector<Vec2> starts = random_places(radii, kSide, 0.3, random);
  const std::vector<Vec2> goals = random_places(radii, kSide, 0.5, random);
  for (std::size_t i = 0; i < kRobots; ++i) {
    scene.scenario.robots.push_back(usual_robot(starts[i], goals[i], kSpeed));
  }
  scene.unit = scene.scenario.duration = 60.0;
  return scene;
}

MovingObstacle person(Vec2 position, double side, Random& random) {
  MovingObstacle person;
  person.position = position;
  person.radius = 0.3;
  person.max_deviation = random.between(0.5, 3.0);
  person.max_speed = random.between(0.5, 1.5);
  for (int k = 0; k < 8; ++k) person.path.push_back(random.in_square(side));
  return person;
}

// Returns a random robot. One in six is a car, and one in six avoids only robots of its own kind,
// while all others avoid it.
RobotSetup any_robot(Vec2 position, double radius, Random& random) {
  RobotSetup robot = usual_robot(position, position, kSpeed);
  robot.radius = radius;
  robot.max_acceleration = random.between(0.5, 2.0);
  robot.max_braking = random.between(0.5, 1.0) * robot.max_acceleration;
  robot.priority = std::ldexp(1.0, static_cast<int>(random.below(21)) - 10);
  robot.heading = random.between(-3.0, 3.0);
  const std::size_t kind = random.below(6);
  if (kind == 0) robot.model = Car{0.3};
  if (kind == 1) robot.layers.bits = robot.avoids.bits = 2;
  if (kind == 2) {
    const DifferentialDrive drive{0.2, 0.1, robot.max_speed, 4.0 * robot.max_acceleration};
    robot.model = drive, robot.radius = radius - drive.offset;
  }
  if (kind == 3) {
    const CarBody body{random.between(-0.4, 0.4), radius};
    robot.model =
        Car{0.4, random.between(0.5, 3.0), body, random.below(2) == 0, AccelerationSet::exact};
  }
  // the center of its disc is at the position
  robot.position = position - disc_center(robot.model, {}, robot.heading);
  robot.goal = robot.position;
  return robot;
}

}  // namespace

Scene among_movers(std::uint64_t seed) {
  Random random(seed, 8);
  Scene scene = in_a_square(random);
  for (int k = 0; k < 8; ++k) {
    MovingObstacle mover;
    mover.position = kFar * circle_point(k, 8);
    const Vec2 way = random.in_square(0.5 * kSide) - mover.position;
    mover.velocity = (random.between(0.5, 1.5) / norm(way)) * way;
    mover.radius = random.between(0.3, 0.8);
    scene.scenario.moving_obstacles.push_back(mover);
  }
  return scene;
}

Scene among_people(std::uint64_t seed) {
  constexpr int kPeople = 6;
  Random random(seed, 9);
  Scene scene = in_a_square(random);
  for (int k = 0; k < kPeople; ++k)
    scene.scenario.moving_obstacles.push_back(
        person(kFar * circle_point(k, kPeople), kSide, random));
  see_far_enough(scene.scenario);
  return scene;
}

Scene mixed_crush(double robot_steps, std::uint64_t seed) {
  constexpr std::size_t kRobots = 60;
  constexpr int kPeople = 5;
  constexpr double kExtent = 14.0;  // m
  Scene scene{usual_scenario()};
  Scenario& scenario = scene.scenario;
  Random random(seed, 10);
  std::vector<double> radii;
  for (std::size_t i = 0; i < kRobots; ++i) radii.push_back(random.between(0.2, 0.4));
  std::sort(radii.rbegin(), radii.rend());
  const std::vector<Vec2> starts = random_places(radii, kExtent, 0.05, random);
  for (std::size_t i = 0; i < kRobots; ++i)
    scenario.robots.push_back(any_robot(starts[i], radii[i], random));
  for (int k = 0; k < kPeople; ++k)
    scenario.moving_obstacles.push_back(
        person((kExtent + 4.0) * circle_point(k, kPeople), kExtent, random));
  for (int k = 0; k < 5; ++k) scene.rallies.push_back(random.in_square(8.0));
  see_far_enough(scenario);
  scenario.duration = std::max(1.0, std::ceil(robot_steps / double(kRobots))) * scenario.time_step;
  return scene;
}

}  // namespace avo::safety
