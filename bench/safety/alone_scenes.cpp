// SPDX-License-Identifier: Apache-2.0
#include "alone_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "evadable.h"
#include "placement.h"

namespace avo::safety {
namespace {

constexpr std::array kTimeSteps{0.1, 0.02, 0.25, 0.05, 0.2, 0.125, 0.04, 0.15, 0.08};  // s
constexpr double kMostRadius = 1.2;  // m, of moving obstacles

Vec2 direction(Random& random) {
  return circle_point(static_cast<int>(random.below(3600)), 3600);
}

MovingObstacle mover(Vec2 position, Vec2 velocity, double radius) {
  MovingObstacle result;
  result.position = position, result.velocity = velocity, result.radius = radius;
  return result;
}

RobotSetup any_size(Vec2 position, Vec2 goal, Random& random) {
  RobotSetup robot;
  robot.position = position, robot.goal = goal;
  robot.radius = random.between(0.2, 0.6);
  robot.max_acceleration = random.between(0.5, 2.0);
  robot.max_speed = robot.preferred_speed = random.between(1.0, 2.5);
  return robot;
}

Scene alone(Vec2 position, Vec2 goal, std::uint64_t seed, Random& random, double duration) {
  Scene scene{usual_scenario()};
  Scenario& scenario = scene.scenario;
  scenario.time_step = kTimeSteps[seed % kTimeSteps.size()];
  scenario.sensing_radius = 80.0;  // m
  scenario.robots = {any_size(position, goal, random)};
  // whole steps
  scenario.duration = scenario.time_step * std::floor(duration / scenario.time_step);
  scene.unit = goal == position ? 0.0 : scenario.duration;
  scene.alone = true;
  return scene;
}

int count_of(std::uint64_t seed) {
  return 1 + static_cast<int>(seed / kTimeSteps.size() % 10);
}

}  // namespace

Scene alone_crossing(std::uint64_t seed) {
  Random random(seed, 13);
  Scene scene = alone({-10.0, 0.0}, {10.0, 0.0}, seed, random, 40.0);
  const RobotSetup& robot = scene.scenario.robots[0];
  std::vector<MovingObstacle>& movers = scene.scenario.moving_obstacles;
  const bool slow = seed % 2 == 0;
  while (movers.size() < static_cast<std::size_t>(count_of(seed))) {
    const double speed = robot.max_speed * (slow ? random.between(0.3, 1.0) : random.between(1, 2));
    const Vec2 velocity = speed * direction(random);
    const double time = random.between(3.0, 14.0);
    const double x = random.between(-7.0, 7.0);
    const Vec2 from = Vec2{x, random.between(-3.0, 3.0)} - time * velocity;
    const double radius = random.between(0.3, kMostRadius);
    if (norm(from - robot.position) < radius + robot.radius + 3.0) continue;
    movers.push_back(mover(from, velocity, radius));
  }
  return scene;
}

Scene alone_at_goal(std::uint64_t seed) {
  Random random(seed, 14);
  Scene scene = alone({}, {}, seed, random, 30.0);
  const RobotSetup& robot = scene.scenario.robots[0];
  std::vector<MovingObstacle>& movers = scene.scenario.moving_obstacles;
  while (movers.size() < static_cast<std::size_t>(count_of(seed))) {
    const double speed = robot.max_speed * random.between(0.2, 1.5);
    const Vec2 along = direction(random);
    const double radius = random.between(0.3, kMostRadius), time = random.between(4.0, 20.0);
    const double aside = random.between(-1.0, 1.0) * (radius + robot.radius);
    const Vec2 from = aside * Vec2{-along.y, along.x} - (time * speed) * along;
    if (norm(from) < radius + robot.radius + 3.0) continue;
    movers.push_back(mover(from, speed * along, radius));
  }
  return scene;
}

Scene alone_over_road(std::uint64_t seed) {
  Random random(seed, 15);
  Scene scene = alone({0.0, -9.0}, {0.0, 9.0}, seed, random, 60.0);
  const int lanes = 1 + static_cast<int>(seed / kTimeSteps.size() % 3);
  for (int lane = 0; lane < lanes; ++lane) {
    const double y = 3.0 * lane - 1.5 * (lanes - 1), side = lane % 2 == 0 ? -1.0 : 1.0;
    const double speed = random.between(0.8, 3.0);
    double away = random.between(2.0, 20.0);
    for (int k = 0; k < 12; ++k) {
      const double radius = random.between(0.6, 1.1);
      scene.scenario.moving_obstacles.push_back(
          mover({side * away, y}, {-side * speed, 0.0}, radius));
      away += speed * random.between(2.5, 8.0) + 2.5;
    }
  }
  return scene;
}

Scene alone_surprised(std::uint64_t seed) {
  Random random(seed, 16);
  for (;;) {
    Scene scene = alone({}, {12.0, 0.0}, seed, random, 20.0);
    RobotSetup& robot = scene.scenario.robots[0];
    robot.velocity = {random.between(0.0, robot.max_speed), 0.0};
    const double speed = random.between(0.6, 4.0), time = random.between(0.7, 3.0);
    const double radius = random.between(0.3, kMostRadius), touch = radius + robot.radius;
    const Vec2 along = direction(random), aside = Vec2{-along.y, along.x};
    const Vec2 from = time * robot.velocity - (time * speed + touch) * along +
                      (random.between(-0.8, 0.8) * touch) * aside;
    if (norm(from) < touch + 0.1) continue;
    scene.scenario.moving_obstacles = {mover(from, speed * along, radius)};
    if (is_evadable(scene.scenario)) return scene;
  }
}

Scene alone_among_paths(std::uint64_t seed) {
  Random random(seed, 17);
  Scene scene = alone({-10.0, 0.0}, {10.0, 0.0}, seed, random, 60.0);
  const int count = 1 + static_cast<int>(seed / kTimeSteps.size() % 4);
  for (int k = 0; k < count; ++k) {
    const double x = -6.0 + 12.0 * (k + random.between(0.2, 0.8)) / count;
    const double tilt = random.between(-1.5, 1.5), length = random.between(3.0, 6.0);
    const double middle = random.between(-1.5, 1.5);
    Vec2 a{x - tilt, middle - length}, b{x + tilt, middle + length};
    if (random.below(2) == 0) std::swap(a, b);
    const double speed = random.between(0.8, 2.0), part = random.between(0.0, 1.0);
    MovingObstacle person =
        mover(a + part * (b - a), (0.9 * speed / norm(b - a)) * (b - a), random.between(0.3, 1.0));
    person.max_deviation = random.between(0.7, 2.0), person.max_speed = speed;
    person.path = {b, a};
    scene.scenario.moving_obstacles.push_back(person);
  }
  return scene;
}

Scene eight_among_movers(std::uint64_t seed) {
  constexpr int kRobots = 8;
  Random random(seed, 18);
  Scene scene{usual_scenario()};
  Scenario& scenario = scene.scenario;
  scenario.sensing_radius = 40.0;
  for (int k = 0; k < kRobots; ++k) {
    const Vec2 p = 10.0 * circle_point(k, kRobots);
    scenario.robots.push_back(usual_robot(p, {-p.x, 0.1 - p.y}, 2.0));
    scenario.robots.back().radius = 0.4;
  }
  while (scenario.moving_obstacles.size() < 6) {
    const Vec2 velocity = random.between(0.6, 3.0) * direction(random);
    const double x = random.between(-7.0, 7.0), radius = random.between(0.3, kMostRadius);
    const Vec2 meets{x, random.between(-3.0, 3.0)};
    const Vec2 from = meets - random.between(4.0, 16.0) * velocity;
    const bool is_far = std::all_of(
        scenario.robots.begin(), scenario.robots.end(),
        [&](const RobotSetup& robot) { return norm(from - robot.position) >= radius + 3.0; });
    if (is_far) scenario.moving_obstacles.push_back(mover(from, velocity, radius));
  }
  scene.unit = scenario.duration = 40.0;
  return scene;
}

}  // namespace avo::safety
