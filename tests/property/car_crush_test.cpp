// SPDX-License-Identifier: Apache-2.0
// Cars of every kind and holonomic robots in a crush: discs ahead of the axle and behind it,
// backwards, both sets of accelerations. Judged on the true arcs of their axles.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "avo/checked.h"
#include "avo/simulation.h"
#include "support/generators.h"

namespace avo::test {
namespace {

Car any_car(Random& random) {
  Car car{.wheelbase = random.uniform(0.5, 1.5)};
  if (random.below(3) != 0) car.max_curvature = random.log_uniform(0.2, 3.0);
  if (random.below(3) != 0) car.body = CarBody{random.uniform(-1.2, 1.2), random.uniform(0.5, 0.9)};
  car.reverse = random.below(2) == 0;
  if (random.below(2) == 0) car.acceleration_set = AccelerationSet::exact;
  return car;
}

// On a circle, with goals that all of them cannot reach.
Scenario crush(Random& random) {
  constexpr int kRobots = 30;
  Scenario scene;
  scene.sensing_radius = 40.0;
  scene.time_step = std::vector<double>{0.05, 0.1, 0.2, 0.4}[random.below(4)];
  for (int k = 0; k < kRobots; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kRobots;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    RobotSetup robot;
    robot.position = 22.0 * out;
    robot.goal = in_disc(random, 3.0);
    robot.radius = random.uniform(0.4, 0.8);
    robot.max_speed = robot.preferred_speed = random.uniform(1.0, 3.0);
    robot.max_acceleration = random.log_uniform(0.5, 2.0);
    if (random.below(4) != 0) {
      robot.model = any_car(random);
      robot.heading = angle + std::numbers::pi + random.uniform(-0.6, 0.6);
    }
    scene.robots.push_back(robot);
  }
  return scene;
}

struct Pose {
  Vec2 position, velocity;
  double heading;
};

// The disc's center at a part of the step, by the controls that lead from one pose to the other.
Vec2 center_at(const RobotSetup& robot, const Pose& from, const Pose& to, double step,
               double part) {
  const double t = part * step;
  if (is_holonomic(robot.model))
    return from.position + t * from.velocity + (0.5 * t * part) * (to.velocity - from.velocity);
  const auto signed_speed = [](const Pose& pose) {
    return dot(pose.velocity, {std::cos(pose.heading), std::sin(pose.heading)});
  };
  const double speed = signed_speed(from), change = signed_speed(to) - speed;
  const double turn = std::remainder(to.heading - from.heading, 2.0 * std::numbers::pi);
  const double whole = (speed + 0.5 * change) * step;
  const bool drives = std::abs(whole) > 1e-9;
  const double length = (speed + 0.5 * part * change) * t;
  const double angle = drives ? turn * length / whole : turn * part * part;
  const double chord =
      std::abs(angle) > 1e-9 ? length * std::sin(0.5 * angle) / (0.5 * angle) : length;
  const double middle = from.heading + 0.5 * angle;
  const Vec2 axle =
      from.position + (drives ? chord : 0.0) * Vec2{std::cos(middle), std::sin(middle)};
  return disc_center(robot.model, axle, from.heading + angle);
}

TEST(CarCrush, nobody_touches_anybody) {
  constexpr int kParts = 8;
  double least = 1e9, off = 0.0;
  std::int64_t robot_steps = 0;
  int arrived = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Scenario scene = crush(random);
    Simulation simulation(scene, 1);
    const auto poses = [&] {
      const FleetView fleet = simulation.fleet();
      std::vector<Pose> all;
      for (std::size_t i = 0; i < fleet.id.size(); ++i)
        all.push_back({fleet.position[i], fleet.velocity[i], fleet.heading[i]});
      return all;
    };
    std::vector<Pose> before = poses();
    while (simulation.time() < 40.0 && !HasFailure()) {
      simulation.step();
      const std::vector<Pose> now = poses();
      const FleetView fleet = simulation.fleet();
      robot_steps += static_cast<std::int64_t>(now.size());
      for (int part = 1; part <= kParts; ++part) {
        std::vector<Vec2> center;
        for (std::size_t i = 0; i < now.size(); ++i)
          center.push_back(center_at(fleet.setup[i], before[i], now[i], scene.time_step,
                                     static_cast<double>(part) / kParts));
        for (std::size_t i = 0; i < now.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, norm(center[i] - center[j]) - disc_radius(fleet.setup[i]) -
                                        disc_radius(fleet.setup[j]));
          if (part == kParts)
            off = std::max(off, norm(center[i] - disc_center(fleet.setup[i].model, now[i].position,
                                                             now[i].heading)));
        }
      }
      EXPECT_GT(least, -1e-9);
      before = now;
    }
    for (std::size_t i = 0; i < before.size(); ++i) arrived += simulation.is_at_goal({i}) ? 1 : 0;
  }
  EXPECT_GT(robot_steps, 70'000);
  EXPECT_LT(least, 1e-3) << "no crush";
  EXPECT_LT(off, 1e-7) << "the judge's arcs are not theirs";
  EXPECT_GT(arrived, 5);
}

// Goals behind the walls of a yard: they press against these, turn there and back off.
TEST(CarCrush, nobody_touches_a_wall) {
  std::int64_t robot_steps = 0;
  double least = 1e9;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scenario scene = crush(random);
    scene.navigation = false;
    scene.obstacles = {{{{{{-26, -26}, {26, -26}, {26, 26}, {-26, 26}}, true}}, 0.0, Fill::bounds},
                       {{{{{-3, -4}, {5, -1}, {2, 6}}, true}}, 0.0, Fill::solid}};
    std::vector<CheckedRobot> robots;
    for (RobotSetup& robot : scene.robots) {
      robot.goal = 40.0 * random.direction();
      if (random.below(4) == 0) robot.goal = in_disc(random, 3.0);
      robots.push_back(checked_robot(robot));
    }
    Check check(robots);
    std::vector<CheckedWall> walls;
    for (const Wall& wall : walls_of(scene.obstacles))
      walls.push_back({wall.a, wall.b, wall.radius});
    check.set_walls(walls);
    Simulation simulation(scene, 1);
    check.add(0.0, checked_states(simulation.fleet()));
    while (simulation.time() < 40.0) {
      simulation.step();
      check.add(simulation.time(), checked_states(simulation.fleet()));
    }
    const CheckReport report = check.report();
    EXPECT_EQ(report.static_contacts.count, 0) << "by " << report.static_contacts.worst;
    EXPECT_TRUE(report.safe());
    robot_steps += report.robot_steps;
    least = std::min(least, report.least_static_clearance.value_or(1e9));
  }
  EXPECT_GT(robot_steps, 25'000);
  EXPECT_LT(least, 1e-3) << "nobody comes near";
}

// Drives among them. Half of all decide twice as often, and all are sent to one point after the
// other.
TEST(CarCrush, with_clocks_of_their_own_nobody_touches_anybody) {
  std::int64_t robot_steps = 0;
  double least = 1e9;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scenario scene = crush(random);
    scene.clock = Clock::free, scene.seed = seed;
    std::vector<CheckedRobot> robots;
    for (RobotSetup& robot : scene.robots) {
      if (random.below(2) == 0) robot.time_step = 0.5 * scene.time_step;
      if (is_holonomic(robot.model) && random.below(2) == 0) {
        const DifferentialDrive drive{.wheel_speed = robot.max_speed,
                                      .wheel_acceleration = 4.0 * robot.max_acceleration};
        robot.model = drive, robot.heading = random.uniform(-3.0, 3.0);
      }
      robots.push_back(checked_robot(robot));
      robots.back().time_step = time_step_of(scene, robot);
    }
    Check check(robots);
    Simulation simulation(scene, 1);
    check.add(0.0, checked_states(simulation.fleet()));
    double next_rally = 0.0;
    while (simulation.time() < 30.0) {
      if (simulation.time() >= next_rally) {
        const Vec2 rally = in_disc(random, 3.0);
        for (std::size_t k = 0; k < robots.size(); ++k) simulation.set_goal({k}, rally);
        next_rally += 8.0;
      }
      simulation.step();
      check.add(simulation.time(), checked_states(simulation.fleet()));
      robot_steps += std::ssize(robots);
    }
    const CheckReport report = check.report();
    EXPECT_EQ(report.overlaps.count, 0) << "by " << report.overlaps.worst;
    EXPECT_EQ(report.changes.count, 0) << "by " << report.changes.worst;
    EXPECT_TRUE(report.safe());
    least = std::min(least, report.least_clearance.value_or(1e9));
  }
  EXPECT_GT(robot_steps, 300'000);
  EXPECT_LT(least, 0.2) << "no crush";
  RecordProperty("least", std::to_string(least));
}

}  // namespace
}  // namespace avo::test
