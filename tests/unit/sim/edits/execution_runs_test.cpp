// SPDX-License-Identifier: Apache-2.0
// Scenes whose bases do not execute exactly (docs/certificate/execution.md): bodies follow the
// references, and do not touch. The judge knows the bodies alone.
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

TEST(ExecutionRuns, bodies_touch_where_no_error_is_declared) {
  for (const ExecutionModel& model : {kSluggish, kJerky}) {
    Scenario scene = crush(model, 1);
    scene.execution_error = 0.0;
    const CheckReport report = judged(scene);
    EXPECT_GT(report.overlaps.count + report.static_contacts.count, 0);
    EXPECT_LT(*report.least_clearance, -0.002);
  }
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
            "robots.2.model: found one that is not holonomic, must be holonomic in "
            "a scene with execution");
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
  parked.parked = true;
  EXPECT_THROW(simulation.change_robot({1}, parked), Error);
  RobotSetup faster = simulation.setup({1});
  faster.max_speed += 0.5;
  simulation.change_robot({1}, faster);
  EXPECT_EQ(simulation.setup({1}).max_speed, faster.max_speed);
  EXPECT_EQ(simulation.setup({1}).radius, faster.radius);
}

}  // namespace
}  // namespace avo::test
