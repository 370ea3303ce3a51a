// SPDX-License-Identifier: Apache-2.0
// The bases of these scenes do not execute exactly (docs/certificate/execution.md). Bodies follow
// the references, and do not touch. The judge knows the bodies alone.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "avo/checked.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/generators.h"
#include "support/refusal.h"

namespace avo::test {
namespace {

constexpr ExecutionModel kSluggish{.time_constant = 0.2,
                                   .time_constant_error = 0.01,
                                   .dead_time = 0.13,
                                   .dead_time_error = 0.005,
                                   .deadband = 0.04,
                                   .quantum = 0.02,
                                   .velocity_error = 0.02,
                                   .measured_position_error = 0.001,
                                   .measured_velocity_error = 0.002};
constexpr ExecutionModel kJerky{.dead_time = 0.1, .deadband = 0.08, .quantum = 0.02};

// All of them want to be at the same place, beside a wall.
Scenario crush(const ExecutionModel& model, std::uint64_t seed) {
  constexpr int kRobots = 20;
  Scenario scene;
  scene.duration = 20.0, scene.seed = seed;
  scene.execution = model;
  scene.obstacles = {{.chains = {Chain{{{-12.0, -1.5}, {12.0, -1.5}}, false}}}};
  Random random(seed);
  for (int k = 0; k < kRobots; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / kRobots;
    RobotSetup robot;
    robot.position = 9.0 * Vec2{std::cos(angle), std::sin(angle)};
    robot.goal = 0.8 * random.uniform(0.0, 1.0) * random.direction();
    robot.radius = 0.4, robot.max_speed = robot.preferred_speed = random.uniform(1.0, 2.0);
    scene.robots.push_back(robot);
  }
  return scene;
}

// The wheels of drives; with and without a lag.
constexpr ExecutionModel kWheels{.time_constant = 0.08,
                                 .time_constant_error = 0.002,
                                 .dead_time = 0.06,
                                 .dead_time_error = 0.001,
                                 .deadband = 0.02,
                                 .quantum = 0.01,
                                 .velocity_error = 0.005,
                                 .heading_age = 0.01,
                                 .measured_velocity_error = 0.001};
constexpr ExecutionModel kHardWheels{
    .dead_time = 0.05, .deadband = 0.05, .quantum = 0.02, .heading_age = 0.02};

// The same of drives, two thirds of all.
Scenario crush_of_drives(const ExecutionModel& model, std::uint64_t seed) {
  Scenario scene = crush(model, seed);
  scene.duration = 40.0;
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    RobotSetup& robot = scene.robots[k];
    robot.max_speed = robot.preferred_speed = 0.4, robot.max_acceleration = 0.5;
    if (k % 3 == 0) continue;
    robot.radius = 0.3, robot.heading = 0.3 * static_cast<double>(k);
    robot.model = DifferentialDrive{
        .track = 0.4, .offset = 0.2, .wheel_speed = 1.5, .wheel_acceleration = 3.0};
  }
  return scene;
}

CheckReport judged(const Scenario& scene) {
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& robot : scene.robots) robots.push_back(checked_robot(scene, robot));
  Check check(robots);
  std::vector<CheckedWall> walls;
  for (const Wall& wall : walls_of(scene.obstacles)) walls.push_back({wall.a, wall.b, wall.radius});
  check.set_walls(walls);
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  check.add(0.0, checked_states(simulation.fleet()));
  while (simulation.can_step_by(scene.duration)) {
    simulation.step();
    metrics.observe(simulation);
    check.add(simulation.time(), checked_states(simulation.fleet()));
  }
  // both are of the bodies, which commands in steps pull harder than their references
  const double largest = check.report().largest_acceleration;
  EXPECT_GT(largest, 1.05 * scene.robots.front().max_acceleration);
  EXPECT_NEAR(metrics.summary().max_acceleration, largest, 1e-9 * largest);
  return check.report();
}

TEST(ExecutionRuns, bodies_touch_neither_each_other_nor_a_wall) {
  for (const ExecutionModel& model : {kSluggish, kJerky}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(seed);
      const CheckReport report = judged(crush(model, seed));
      EXPECT_TRUE(report.safe());
      EXPECT_EQ(report.overlaps.count, 0) << "by " << report.overlaps.worst;
      EXPECT_EQ(report.static_contacts.count, 0) << "by " << report.static_contacts.worst;
      EXPECT_GE(*report.least_clearance, 0.0);
    }
  }
}

// What robots sense of others, in place of being told their references.
const SensingModel kNoisy{.noise = {.position = 0.01, .velocity = 0.02}};
const SensingModel kLate{
    .noise = {.position = 0.01, .velocity = 0.02, .distribution = NoiseDistribution::uniform},
    .delay = 1,
    .dropped = 0.1};

TEST(ExecutionRuns, bodies_that_are_sensed_with_errors_touch_neither_each_other_nor_a_wall) {
  for (const SensingModel& sensing : {kNoisy, kLate}) {
    for (const ExecutionModel& model : {kSluggish, kJerky}) {
      for (const std::uint64_t seed : {1, 2}) {
        SCOPED_TRACE(seed);
        Scenario scene = crush(model, seed);
        scene.sensing = sensing, scene.duration = 30.0;
        const CheckReport report = judged(scene);
        EXPECT_TRUE(report.safe());
        EXPECT_EQ(report.overlaps.count, 0) << "by " << report.overlaps.worst;
        EXPECT_EQ(report.static_contacts.count, 0) << "by " << report.static_contacts.worst;
      }
    }
    Scenario drives = crush_of_drives(kWheels, 1);
    drives.sensing = sensing;
    EXPECT_EQ(judged(drives).overlaps.count, 0);
  }
}

// m, of the references, at the decisions.
double least_clearance_of_references(const Scenario& scene) {
  Simulation simulation(scene, 1);
  double least = 1.0;
  while (simulation.can_step_by(scene.duration)) {
    simulation.step();
    std::vector<Robot> robots;
    for (std::size_t k = 0; k < simulation.size(); ++k)
      robots.push_back(simulation.perceive({k}).robot);
    for (std::size_t a = 0; a < robots.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        least = std::min(least, norm(robots[a].position - robots[b].position) - robots[a].radius -
                                    robots[b].radius);
  }
  return least;
}

// The errors of bodies count with those of the sensor.
TEST(ExecutionRuns, references_overlap_where_the_errors_of_sensed_bodies_are_not_declared) {
  Scenario scene = crush(kSluggish, 1);
  scene.sensing = {.noise = {.position = 1e-6}};
  EXPECT_GE(least_clearance_of_references(scene), -1e-9);
  scene.sensing_error = SensingError{1e-5, 1e-5};
  EXPECT_LT(least_clearance_of_references(scene), -0.01);
}

TEST(ExecutionRuns, declare_how_far_bodies_are_from_their_references) {
  Scenario scene = crush(kSluggish, 1);
  EXPECT_EQ(declared_error(scene), SensingError{}) << "they tell their references";
  scene.sensing = kLate;
  Robot strongest;
  strongest.max_acceleration = scene.robots.front().max_acceleration;
  strongest.max_speed = 2.0;
  const ExecutionError off = execution_error(kSluggish, strongest, scene.time_step);
  const double late = scene.time_step;  // s
  EXPECT_NEAR(declared_error(scene).velocity,
              0.02 * std::numbers::sqrt2 + off.velocity + late * strongest.max_acceleration, 1e-9);
  EXPECT_NEAR(declared_error(scene).position,
              0.01 * std::numbers::sqrt2 + off.position +
                  late * (0.02 * std::numbers::sqrt2 + off.velocity) +
                  0.5 * late * late * strongest.max_acceleration,
              1e-9);
  Simulation simulation(scene, 1);
  EXPECT_EQ(simulation.planner().options().sensing_error, declared_error(scene));
  RobotSetup stronger = scene.robots[0];
  stronger.position = {0.0, 20.0}, stronger.max_acceleration = 1.5;
  EXPECT_EQ(refusal([&] { simulation.add_robot(stronger); }).find("robot 20: sensing_error"), 0U);
  stronger.max_acceleration = 1.0;
  EXPECT_EQ(refusal([&] { simulation.add_robot(stronger); }), "");
  for (int k = 0; k < 30; ++k) simulation.step();
  EXPECT_NE(simulation.perceive({3}).neighbors.front().position,
            simulation.perceive({3}).robot.position);
  Simulation other(simulation.save(), 2);
  for (int k = 0; k < 30; ++k) simulation.step(), other.step();
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
}

TEST(ExecutionRuns, bodies_touch_where_no_error_is_declared) {
  for (const ExecutionModel& model : {kSluggish, kJerky}) {
    Scenario scene = crush(model, 1);
    scene.execution_error = 0.0;
    const CheckReport report = judged(scene);
    EXPECT_GT(report.overlaps.count + report.static_contacts.count, 0);
    EXPECT_LT(*report.least_clearance, -0.002);
  }
}

TEST(ExecutionRuns, drives_touch_neither_each_other_nor_a_wall) {
  for (const ExecutionModel& model : {kWheels, kHardWheels}) {
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(seed);
      const CheckReport report = judged(crush_of_drives(model, seed));
      EXPECT_TRUE(report.safe());
      EXPECT_EQ(report.overlaps.count, 0) << "by " << report.overlaps.worst;
      EXPECT_EQ(report.static_contacts.count, 0) << "by " << report.static_contacts.worst;
      EXPECT_EQ(report.jumps.count, 0) << "by " << report.jumps.worst;
      EXPECT_GE(*report.least_clearance, 0.0);
    }
  }
}

TEST(ExecutionRuns, drives_touch_where_no_error_is_declared) {
  Scenario scene = crush_of_drives(kHardWheels, 1);
  scene.execution_error = 0.0;
  EXPECT_LT(*judged(scene).least_clearance, -0.001);
}

TEST(ExecutionRuns, drives_stay_within_their_bounds_and_save_their_headings) {
  const Scenario scene = crush_of_drives(kWheels, 3);
  Simulation bodies(scene, 1);
  const double most =
      execution_error(kWheels,
                      {.max_acceleration = 0.5, .max_speed = 0.4, .model = scene.robots[1].model},
                      scene.time_step)
          .position;
  double farthest = 0.0;
  for (int k = 0; k < 200; ++k) {
    bodies.step();
    for (const std::size_t robot : {1U, 2U, 4U}) {
      const RobotSetup body = bodies.setup({robot});
      const Vec2 reference = bodies.perceive({robot}).robot.position;
      farthest = std::max(farthest, norm(disc_center(body) - reference));
    }
  }
  EXPECT_LE(farthest, most);
  EXPECT_GT(farthest, 0.1 * most);
  Simulation other(bodies.save(), 1);
  for (int k = 0; k < 20; ++k) bodies.step(), other.step();
  EXPECT_EQ(bodies.state_hash(), other.state_hash());
  EXPECT_EQ(bodies.robot({4}).heading, other.robot({4}).heading);
  EXPECT_EQ(bodies.robot({4}).position, bodies.fleet().position[4]);
}

TEST(ExecutionRuns, drives_are_refused_what_has_no_bound) {
  const Scenario sound = crush_of_drives(kWheels, 1);
  EXPECT_EQ(refusal(sound), "");
  Scenario scene = sound;
  scene.execution->heading_age = 0.0;
  EXPECT_EQ(refusal(scene),
            "execution.heading_age: found 0, must be >= 1e-04 s with a differential drive: the "
            "period of its wheels");
  scene.execution->heading_age = 0.3;
  EXPECT_EQ(refusal(scene).find("robots.1.drive: ExecutionModel: found no bound"), 0U);
  scene = sound;
  std::get<DifferentialDrive>(scene.robots[1].model).footprint = {
      .discs = 2, .radius = 0.3, .first = -0.2, .spacing = 0.4};
  EXPECT_EQ(refusal(scene).find("robots.1.footprint: found one"), 0U) << refusal(scene);
  Simulation simulation(sound, 1);
  RobotSetup slower = simulation.setup({1});
  slower.max_speed = slower.preferred_speed = 0.3;
  EXPECT_THROW(simulation.change_robot({1}, slower), Error);
  EXPECT_NO_THROW(simulation.move_robot({1}, {0.0, 20.0}));
  EXPECT_EQ(simulation.robot({1}).position, (Vec2{0.0, 20.0}));
}

// The greatest distances of a body from its reference, as its commands say where that is.
TEST(ExecutionRuns, bodies_are_elsewhere_than_what_was_decided) {
  const Scenario scene = crush(kSluggish, 1);
  Scenario exact = scene;
  exact.execution.reset();
  for (RobotSetup& robot : exact.robots) {
    Robot limits;
    limits.max_speed = robot.max_speed;
    robot.radius += execution_error(kSluggish, limits, scene.time_step).position;
  }
  Simulation bodies(scene, 1), references(exact, 1);
  double most = 0.0;
  while (bodies.time() < 15.0) {
    bodies.step(), references.step();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const double deviation = norm(bodies.fleet().position[k] - references.fleet().position[k]);
      EXPECT_LE(deviation, exact.robots[k].radius - scene.robots[k].radius);
      most = std::max(most, deviation);
    }
  }
  EXPECT_GT(most, 0.01);
  EXPECT_EQ(bodies.setup({3}).radius, scene.robots[3].radius);
  EXPECT_EQ(bodies.fleet().setup[3].radius, scene.robots[3].radius);
  EXPECT_EQ(bodies.robot({3}).position, bodies.fleet().position[3]);
}

TEST(ExecutionRuns, go_on_from_what_was_saved) {
  Simulation simulation(crush(kSluggish, 2), 1);
  for (int k = 0; k < 40; ++k) simulation.step();
  simulation.remove_robot({4});
  const RobotId late = simulation.add_robot({.position = {0.0, 14.0}, .goal = {0.0, 3.0}});
  simulation.move_robot({5}, {0.0, 17.0});
  for (int k = 0; k < 15; ++k) simulation.step();
  const std::vector<std::byte> saved = simulation.save();
  Simulation other(saved, 2), restored(crush(kSluggish, 2), 1);
  restored.restore(saved);
  for (int k = 0; k < 30; ++k) simulation.step(), other.step(), restored.step();
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
  EXPECT_EQ(simulation.state_hash(), restored.state_hash());
  EXPECT_GT(norm(simulation.robot(late).velocity), 0.1);
  Scenario exact = crush(kSluggish, 2);
  exact.execution.reset();
  Simulation without(exact, 1);
  EXPECT_THROW(without.restore(saved), Error);
}

TEST(ExecutionRuns, refuse_what_has_no_bound) {
  const Scenario sound = crush(kSluggish, 1);
  EXPECT_EQ(refusal(sound), "");
  Scenario scene = sound;
  scene.robots[2].model = Car{};
  EXPECT_EQ(refusal(scene),
            "robots.2.model: found another one, must be holonomic or differential_drive in a scene "
            "with execution");
  scene = sound, scene.robots[3].velocity = {1.0, 0.0};
  EXPECT_EQ(refusal(scene),
            "robots.3.velocity: found [1, 0], must be [0, 0] in a scene with "
            "execution: bases start at rest");
  scene = sound, scene.clock = Clock::free;
  EXPECT_EQ(refusal(scene), "clock: found free, must be common in a scene with execution");
  scene = sound, scene.robots[1].method = Method::orca;
  EXPECT_EQ(refusal(scene),
            "robots.1.method: found orca, must be one that keeps max_acceleration "
            "in a scene with execution");
  scene = sound, scene.execution->dead_time = -1.0;
  EXPECT_EQ(refusal(scene), "execution.dead_time: found -1, must be >= 0 s");
  scene = sound, scene.execution.reset(), scene.execution_error = 0.1;
  EXPECT_EQ(refusal(scene), "execution: found none, must be given where execution_error is");
  Simulation simulation(sound, 1);
  RobotSetup stronger = simulation.setup({1});
  stronger.max_acceleration = 2.0;
  EXPECT_THROW(simulation.change_robot({1}, stronger), Error);
  RobotSetup hasty = simulation.setup({1});
  hasty.method = Method::orca;
  EXPECT_THROW(simulation.change_robot({1}, hasty), Error);
  hasty.position = {0.0, 20.0};
  EXPECT_THROW(simulation.add_robot(hasty), Error);
  RobotSetup parked = simulation.setup({1});
  parked.behavior = Behavior::parked;
  EXPECT_THROW(simulation.change_robot({1}, parked), Error);
  RobotSetup faster = simulation.setup({1});
  faster.max_speed += 0.5;
  simulation.change_robot({1}, faster);
  EXPECT_EQ(simulation.setup({1}).max_speed, faster.max_speed);
  EXPECT_EQ(simulation.setup({1}).radius, faster.radius);
}

}  // namespace
}  // namespace avo::test
