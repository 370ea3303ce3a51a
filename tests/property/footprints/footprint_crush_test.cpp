// SPDX-License-Identifier: Apache-2.0
// Trucks, forklifts and drives of rows of discs in a crush, with holonomic robots among them. The
// judge knows their discs by its own geometry.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "avo/checked.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/generators.h"

namespace avo::test {
namespace {

Footprint any_footprint(Random& random) {
  const double length = random.uniform(1.2, 4.0), width = random.uniform(0.3, 0.8) * length;
  return cover_rectangle(length, width, random.uniform(-0.2, 0.9) * 0.5 * length,
                         random.uniform(0.15, 0.3) * width);
}

MotionModel any_covered(Random& random, double max_speed, double max_acceleration) {
  const Footprint footprint = any_footprint(random);
  if (random.below(3) == 0)
    return DifferentialDrive{.track = random.uniform(0.4, 1.0),
                             .offset = random.uniform(0.2, 0.8),
                             .wheel_speed = max_speed,
                             .wheel_acceleration = 5.0 * max_acceleration,
                             .footprint = footprint};
  Car car{.wheelbase = random.uniform(0.5, 2.5)};
  if (random.below(3) != 0) car.max_curvature = random.log_uniform(0.2, 1.5);
  car.reverse = random.below(2) == 0;
  if (random.below(3) == 0) car.acceleration_set = AccelerationSet::exact;
  car.footprint = footprint;
  return car;
}

// On a circle, with goals that all of them cannot reach.
Scenario crush(Random& random) {
  constexpr int kRobots = 22;
  Scenario scene;
  scene.sensing_radius = 40.0;
  scene.time_step = std::vector<double>{0.05, 0.1, 0.2}[random.below(3)];
  for (int k = 0; k < kRobots; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kRobots;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    RobotSetup robot;
    robot.position = 30.0 * out;
    robot.goal = in_disc(random, 4.0);
    robot.max_speed = robot.preferred_speed = random.uniform(1.0, 3.0);
    robot.max_acceleration = random.log_uniform(0.5, 2.0);
    if (random.below(4) != 0) {
      robot.model = any_covered(random, robot.max_speed, robot.max_acceleration);
      robot.heading = angle + std::numbers::pi + random.uniform(-0.6, 0.6);
    }
    scene.robots.push_back(robot);
  }
  return scene;
}

struct Judged {
  CheckReport report;
  int refused = 0;  // decisions that the certificate changed, or overlaps that it told of
  int overlapping = 0;
};

Judged run(const Scenario& scene, double duration) {
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& robot : scene.robots) robots.push_back(checked_robot(robot));
  std::vector<CheckedMover> movers;
  for (const MovingObstacle& mover : scene.moving_obstacles)
    movers.push_back({mover.position, mover.velocity, mover.acceleration, mover.radius});
  Check check(robots, movers, {.movers_at_rest = true});
  std::vector<CheckedWall> walls;
  for (const Wall& wall : walls_of(scene.obstacles)) walls.push_back({wall.a, wall.b, wall.radius});
  check.set_walls(walls);
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  check.add(0.0, checked_states(simulation.fleet()));
  Judged judged;
  while (simulation.time() < duration) {
    simulation.step();
    metrics.observe(simulation);
    check.add(simulation.time(), checked_states(simulation.fleet()));
    for (const Plan& plan : simulation.fleet().plan) {
      judged.refused += plan.status == PlanStatus::refused ? 1 : 0;
      judged.overlapping += plan.status == PlanStatus::overlapping ? 1 : 0;
    }
  }
  judged.report = check.report();
  // the metrics have their own geometry
  EXPECT_NEAR(*metrics.summary().min_clearance, *judged.report.least_clearance, 1e-5);
  return judged;
}

TEST(FootprintCrush, nobody_touches_anybody) {
  double least = 1e9;
  std::int64_t robot_steps = 0, refused = 0, arrived = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Judged judged = run(crush(random), 30.0);
    EXPECT_EQ(judged.report.overlaps.count, 0) << "by " << judged.report.overlaps.worst;
    EXPECT_TRUE(judged.report.safe());
    EXPECT_EQ(judged.overlapping, 0);
    robot_steps += judged.report.robot_steps, refused += judged.refused;
    arrived += judged.report.arrived;
    least = std::min(least, judged.report.least_clearance.value_or(1e9));
  }
  EXPECT_GT(robot_steps, 20'000);
  EXPECT_GT(refused, 500);
  EXPECT_LT(least, 1e-3) << "no crush";
  EXPECT_GT(arrived, 5);
}

// Goals behind the walls of a yard: they press against these, turn there and back off.
TEST(FootprintCrush, nobody_touches_a_wall) {
  double least = 1e9;
  for (std::uint64_t seed = 20; seed < 23; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scenario scene = crush(random);
    scene.navigation = false;
    scene.obstacles = {{{{{{-36, -36}, {36, -36}, {36, 36}, {-36, 36}}, true}}, 0.0, Fill::bounds},
                       {{{{{-3, -4}, {5, -1}, {2, 6}}, true}}, 0.0, Fill::solid}};
    for (RobotSetup& robot : scene.robots)
      if (random.below(4) != 0) robot.goal = 50.0 * random.direction();
    const Judged judged = run(scene, 25.0);
    EXPECT_EQ(judged.report.static_contacts.count, 0)
        << "by " << judged.report.static_contacts.worst;
    EXPECT_TRUE(judged.report.safe());
    least = std::min(least, judged.report.least_static_clearance.value_or(1e9));
  }
  EXPECT_LT(least, 1e-3) << "nobody comes near";
}

// They see others and walls with errors, and movers come through the crowd.
TEST(FootprintCrush, with_errors_nobody_touches_anybody) {
  for (std::uint64_t seed = 40; seed < 43; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scenario scene = crush(random);
    scene.seed = seed;
    scene.sensing.noise = {
        .position = 0.02, .velocity = 0.03, .distribution = NoiseDistribution::uniform};
    if (random.below(2) == 0) scene.sensing.localization.position = 0.05;
    scene.obstacles = {{{{{{-3, -4}, {5, -1}, {2, 6}}, true}}, 0.0, Fill::solid}};
    for (int k = 0; k < 3; ++k) {
      MovingObstacle mover;
      mover.position = 20.0 * random.direction();
      mover.velocity = (-0.04 * random.uniform(0.5, 1.0)) * mover.position;
      mover.radius = 0.4;
      scene.moving_obstacles.push_back(mover);
    }
    const Judged judged = run(scene, 25.0);
    EXPECT_EQ(judged.report.overlaps.count, 0) << "by " << judged.report.overlaps.worst;
    EXPECT_EQ(judged.report.static_contacts.count, 0);
    EXPECT_EQ(judged.report.mover_contacts_moving.count, 0);
    EXPECT_TRUE(judged.report.safe());
  }
}

// A fleet from 1024 robots on sorts its robots as it steps. One robot far away changes nothing
// else.
TEST(FootprintCrush, robots_are_sensed_the_same_in_fleets_that_sort_theirs) {
  Random random(60);
  Scenario scene;
  scene.sensing_radius = 20.0;
  for (int k = 0; k < 1023; ++k) {
    RobotSetup robot;
    robot.position = {12.0 * (k % 32), 12.0 * (k / 32)};
    robot.goal = robot.position + 20.0 * random.direction();
    robot.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
    robot.model = any_covered(random, robot.max_speed, robot.max_acceleration);
    scene.robots.push_back(robot);
  }
  for (int k = 1022; k > 0; --k)
    std::swap(scene.robots[static_cast<std::size_t>(k)],
              scene.robots[static_cast<std::size_t>(random.below(k + 1))]);
  Simulation unsorted(scene, 1);
  RobotSetup remote;
  remote.position = remote.goal = {-1000.0, 0.0};
  scene.robots.push_back(remote);
  Simulation sorted(scene, 1);
  while (unsorted.time() < 4.0) unsorted.step(), sorted.step();
  for (std::size_t k = 0; k < 1023; ++k)
    ASSERT_EQ(unsorted.fleet().position[k], sorted.fleet().position[k]) << k;
}

// What perceive() tells of a neighbor is what the robot plans with.
TEST(FootprintCrush, perceived_footprints_have_the_pose_of_now) {
  for (const double noise : {0.0, 0.02}) {
    Random random(70);
    Scenario scene = crush(random);
    scene.sensing.noise.position = noise;
    scene.sensing.noise.distribution = NoiseDistribution::uniform;
    Simulation simulation(scene, 1);
    const Planner& planner = simulation.planner();
    for (int step = 0; step < 30; ++step) simulation.step();
    std::size_t covered = 0;
    for (std::size_t a = 0; a < scene.robots.size(); ++a) {
      const Simulation::Perception seen = simulation.perceive({a});
      for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
        const Neighbor& other = seen.neighbors[k];
        if (!other.footprint) continue;
        ++covered;
        const auto b = static_cast<std::size_t>(seen.source[k]);
        const BrakingPose pose = planner.braking_pose(simulation.perceive({b}).robot);
        EXPECT_EQ(other.ahead, pose.ahead);
        EXPECT_EQ(other.spread, pose.spread);
      }
    }
    EXPECT_GT(covered, 100U);
  }
}

}  // namespace
}  // namespace avo::test
