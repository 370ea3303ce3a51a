// SPDX-License-Identifier: Apache-2.0
// Scenes of robots among themselves. All robots start at rest.
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "avo/assumptions.h"
#include "placement.h"

namespace avo::safety {

double straight_time(const Scenario& scenario) {
  double longest = 0.0;
  for (const RobotSetup& robot : scenario.robots) {
    const double d = norm(robot.goal - robot.position), a = robot.max_acceleration;
    const double v = std::min(robot.preferred_speed, robot.max_speed);
    longest = std::max(longest, d * a >= v * v ? d / v + v / a : 2.0 * std::sqrt(d / a));
  }
  return longest;
}

void see_far_enough(Scenario& scenario) {
  if (const std::optional<SensingNeed> need = sensing_need(scenario)) {
    scenario.sensing_radius = std::max(sensing_radius_of(scenario), need->range);
  }
}

Scene with_clocks(Scene scene, bool unequal, std::uint64_t seed) {
  Scenario& scenario = scene.scenario;
  scenario.seed = seed;
  scenario.clock = Clock::free;
  for (std::size_t i = 0; i < scenario.robots.size() && unequal; i += 2)
    scenario.robots[i].time_step = 0.5 * scenario.time_step;
  see_far_enough(scenario);
  return scene;
}

Scenario usual_scenario() {
  Scenario scenario;
  scenario.time_step = 0.1;
  scenario.sensing_radius = 15.0;
  scenario.max_neighbors = 10;
  scenario.arrival_distance = 0.5;
  return scenario;
}

RobotSetup usual_robot(Vec2 position, Vec2 goal, double preferred_speed) {
  RobotSetup robot;
  robot.position = position;
  robot.goal = goal;
  robot.radius = 0.5;
  robot.max_speed = 2.0;
  robot.max_acceleration = 1.0;
  robot.preferred_speed = preferred_speed;
  return robot;
}

Scene within_duration(Scenario scenario) {
  Scene scene{std::move(scenario)};
  scene.unit = scene.scenario.duration;
  return scene;
}

Scene measured_by_straight_time(Scenario scenario) {
  Scene scene{std::move(scenario)};
  scene.unit = straight_time(scene.scenario);
  scene.limit = 4.5;
  scene.share = 0.99;
  scene.scenario.duration = scene.limit * scene.unit;
  return scene;
}

Scene until_rest(Scenario scenario, double units) {
  Scene scene{std::move(scenario)};
  scene.unit = straight_time(scene.scenario);
  scene.limit = units;
  scene.until_rest = true;
  return scene;
}

Scene mixed(std::uint64_t seed) {
  constexpr std::size_t kRobots = 60;
  Scenario scenario = usual_scenario();
  Random random(seed, 5);
  std::vector<double> radii;
  double area = 0.0;
  for (std::size_t i = 0; i < kRobots; ++i) radii.push_back(random.between(0.2, 1.5));
  std::sort(radii.rbegin(), radii.rend());  // large robots find room first
  for (const double radius : radii) area += kPi * radius * radius;
  const double side = std::sqrt(area / 0.15);
  const std::vector<Vec2> starts = random_places(radii, side, 0.3, random);
  const std::vector<Vec2> goals = random_places(radii, side, 0.5, random);
  for (std::size_t i = 0; i < kRobots; ++i) {
    RobotSetup robot = usual_robot(starts[i], goals[i], 0.0);
    robot.radius = radii[i];
    robot.max_acceleration = random.between(0.3, 3.0);
    robot.max_speed = random.between(1.0, 2.5);
    robot.preferred_speed = 0.8 * robot.max_speed;
    scenario.robots.push_back(robot);
  }
  see_far_enough(scenario);
  return measured_by_straight_time(std::move(scenario));
}

Scene touching_goals(int n, bool hexagonal, std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, 23);
  const auto rows = static_cast<int>(std::lround(std::sqrt(n)));
  constexpr double kDiameter = 1.0;  // m
  std::vector<Vec2> goals =
      hexagonal ? triangular_block(rows, rows, kDiameter) : block({}, rows, rows, kDiameter);
  goals = dealt_anew(std::move(goals), random);
  const double inner = 0.75 * rows * kDiameter + 2.0, side = 2.0 * (inner + rows * kDiameter);
  std::vector<Vec2> starts;
  while (starts.size() < goals.size()) {
    const Vec2 place = random.in_square(side);
    bool is_clear = norm(place) > inner;
    for (const Vec2 other : starts) is_clear = is_clear && norm(place - other) > 1.3 * kDiameter;
    if (is_clear) starts.push_back(place);
  }
  for (std::size_t k = 0; k < goals.size(); ++k)
    scenario.robots.push_back(usual_robot(starts[k], goals[k], kSpeed));
  scenario.duration = 360.0;
  Scene scene = until_rest(std::move(scenario), 0.0);
  scene.limit = 300.0 / scene.unit;
  return scene;
}

Scene crush(bool packed, double robot_steps, std::uint64_t seed) {
  constexpr std::size_t kRobots = 200;
  Scene scene{usual_scenario()};
  Random random(seed, 6);
  std::vector<double> radii(kRobots, 0.5);
  if (!packed) {
    for (double& radius : radii) radius = random.between(0.3, 0.6);
    std::sort(radii.rbegin(), radii.rend());
  }
  // four fifths of the densest packing: each robot has a quarter more area, 0.118 m between them
  const std::vector<Vec2> starts =
      packed ? triangular_block(20, 10, std::sqrt(1.25)) : random_places(radii, 22.0, 0.1, random);
  for (int k = 0; k < 5; ++k) scene.rallies.push_back(random.in_square(8.0));
  for (std::size_t i = 0; i < kRobots; ++i) {
    RobotSetup robot = usual_robot(starts[i], scene.rallies[0], kSpeed);
    robot.radius = radii[i];
    robot.max_acceleration = random.between(0.3, 3.0);
    scene.scenario.robots.push_back(robot);
  }
  Scenario& scenario = scene.scenario;
  see_far_enough(scenario);
  scenario.duration = std::max(1.0, std::ceil(robot_steps / double(kRobots))) * scenario.time_step;
  return scene;
}

Scene airplanes(bool mixed, double robot_steps, std::uint64_t seed) {
  constexpr std::size_t kRobots = 100;
  Scene scene{usual_scenario()};
  Random random(seed, 7);
  for (int k = 0; k < 5; ++k) scene.rallies.push_back(random.in_square(20.0));
  std::vector<RobotSetup> robots;
  std::vector<Vec2> centers;  // for each place: the middle of the area that it does not leave
  double room = 0.0;          // m, the largest radius of that area
  for (std::size_t i = 0; i < kRobots; ++i) {
    RobotSetup robot = usual_robot({}, scene.rallies[0], kSpeed);
    robot.radius = random.between(0.3, 0.6);
    robot.max_acceleration = random.between(0.3, 3.0);
    robot.priority = i % 2 == 0 ? 1.0 : random.between(0.01, 4.0);
    robot.heading = random.between(-kPi, kPi);
    LoiterCircle circle;
    if (!mixed || i % 3 == 0) {
      const Airplane airplane{random.between(0.4, 1.2), random.between(0.8, 3.0)};
      const Vec2 heading{std::cos(robot.heading), std::sin(robot.heading)};
      robot.velocity = airplane.min_speed * heading;
      robot.model = airplane;
      circle = loiter_circle(airplane, {}, robot.velocity);
    } else if (i % 3 == 1) {
      robot.model = Car{.max_curvature = 0.8, .reverse = true};
    }
    robots.push_back(robot);
    centers.push_back(circle.center);
    room = std::max(room, circle.radius + robot.radius);
  }
  const std::vector<Vec2> starts =
      random_places(std::vector<double>(kRobots, room), 30.0 * room, 0.1, random);
  for (std::size_t i = 0; i < kRobots; ++i) {
    robots[i].position = starts[i] - centers[i];
    scene.scenario.robots.push_back(robots[i]);
  }
  Scenario& scenario = scene.scenario;
  see_far_enough(scenario);
  scenario.duration = std::max(1.0, std::ceil(robot_steps / double(kRobots))) * scenario.time_step;
  return scene;
}

}  // namespace avo::safety
