// SPDX-License-Identifier: Apache-2.0
// Whatever a run reaches is saved and read, however strange its parameters are, as long as they are
// valid; what no run reaches is refused (saved_bytes_test.cpp).
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "avo/error.h"
#include "avo/simulation.h"
#include "support/generators.h"
#include "support/refusal.h"
#include "unit/sim/saving.h"

namespace avo {
namespace {

using test::Bytes;
using test::Random;

MotionModel any_model(Random& random, double size, const RobotSetup& robot) {
  switch (random.below(4)) {
    case 0: {
      Car car{.wheelbase = size};
      if (random.below(2) == 0)
        car.body = CarBody{size * random.uniform(-1, 1), size * random.uniform(0.1, 1.0)};
      if (random.below(2) == 0) car.max_curvature = random.log_uniform(0.1, 10.0) / size;
      car.reverse = random.below(2) == 0;
      return car;
    }
    case 1:
      return DifferentialDrive{.track = 0.4 * size,
                               .offset = size * random.uniform(0.1, 0.5),
                               .wheel_speed = 2.0 * robot.max_speed,
                               .wheel_acceleration = 9.0 * robot.max_acceleration};
    default:
      return Holonomic{};
  }
}

// Limits over many decades, in steps that are long or short beside what it takes to reach a speed.
RobotSetup any_robot(Random& random, double size, double time_step) {
  RobotSetup robot;
  robot.max_speed = size * random.log_uniform(1e-3, 1e3);
  robot.max_acceleration = robot.max_speed / time_step * random.log_uniform(1e-2, 1e4);
  robot.preferred_speed = robot.max_speed * random.uniform(0.0, 1.0);
  robot.radius = size * random.uniform(0.1, 1.0);
  robot.position = {size * random.uniform(-4, 4), size * random.uniform(-4, 4)};
  robot.goal = {size * random.uniform(-4, 4), size * random.uniform(-4, 4)};
  robot.heading = random.below(4) == 0 ? random.uniform(-1e6, 1e6) : random.uniform(-3, 3);
  if (random.below(3) == 0) robot.max_braking = random.uniform(0.1, 1.0) * robot.max_acceleration;
  robot.model = any_model(random, size, robot);
  if (random.below(8) == 0) robot.behavior = Behavior::parked, robot.goal = robot.position;
  return robot;
}

Scenario any_scene(Random& random) {
  Scenario scene{.allow_broken_assumptions = true};
  const double size = random.log_uniform(1e-3, 1e6);  // m
  scene.time_step = random.log_uniform(1e-3, 1e2);
  scene.control_time = scene.time_step * random.log_uniform(1.0, 50.0);
  if (random.below(4) == 0) {
    scene.time_step = std::round(scene.time_step * 1e6) / 1e6;
    scene.control_time = 2.0 * scene.time_step;
    scene.clock = Clock::free;
    scene.longest_step = scene.time_step;
  } else if (random.below(4) == 0) {
    scene.sensing.delay = 1 + random.below(3);
  }
  if (random.below(2) == 0) {
    scene.response_time = random.uniform(0.0, 0.5), scene.margin = size * random.uniform(0.0, 1.0);
    scene.comfort_acceleration = random.log_uniform(1e-3, 1e2);
    scene.comfort_jerk = random.log_uniform(1e-3, 1e2);
    scene.never_swerves = random.below(2) == 0;
  }
  const double far = random.below(2) * random.log_uniform(1.0, 5e11);
  const Vec2 origin{far * random.uniform(-1, 1), far * random.uniform(-1, 1)};
  for (int k = 2 + random.below(6); k > 0; --k) {
    RobotSetup robot = any_robot(random, size, scene.time_step);
    // one goal for some of them, beside which the others stay
    if (!scene.robots.empty() && random.below(2) == 0 && !is_parked(robot))
      robot.goal = scene.robots[0].goal - origin;
    robot.position = origin + robot.position;
    robot.goal = is_parked(robot) ? robot.position : origin + robot.goal;
    scene.robots.push_back(robot);
  }
  return scene;
}

TEST(Saving, whatever_a_run_reaches_is_read) {
  Random random(15);
  int scenes = 0;
  for (int i = 0; i < 250; ++i) {
    const Scenario scene = any_scene(random);
    if (!test::refusal(scene).empty()) continue;
    ++scenes;
    Simulation simulation(scene, 1);
    for (int k = 0; k < 40; ++k) {
      simulation.step();
      const Bytes saved = simulation.save();
      ASSERT_EQ(test::refusal([&] {
                  if (Simulation(saved, 1).save() != saved) throw Error("other bytes");
                }),
                "")
          << "scene " << i << ", step " << k;
    }
  }
  EXPECT_GT(scenes, 100);
}

// Steps so long that a robot is at its full speed, and at rest again, hundreds of times within one.
// A parked robot senses nothing and declares nothing: one that comes later is saved as well.
TEST(Saving, parked_robots_alone_are_read) {
  Scenario scene;
  scene.sensing.delay = 1;
  Simulation simulation(scene, 1);
  RobotSetup parked;
  parked.behavior = Behavior::parked;
  parked.max_acceleration = 7.0;
  simulation.add_robot(parked);
  Simulation restored(simulation.save(), 1);
  simulation.step(), restored.step();
  EXPECT_EQ(restored.state_hash(), simulation.state_hash());
  EXPECT_TRUE(restored.save() == simulation.save());
}

TEST(Saving, what_robots_remember_stays_in_its_range) {
  for (const double max_speed : {0.35, 0.1, 1e-3, 1e-9}) {
    Scenario scene{.allow_broken_assumptions = true};
    for (int k = 0; k < 4; ++k) {
      RobotSetup robot = test::robot_at({1.02 * k, 0}, {k < 2 ? 1.02 : 2.04, 0});
      robot.max_speed = robot.preferred_speed = max_speed;
      robot.max_acceleration = 50.0;
      robot.radius = 0.5e-3 * max_speed, robot.position.x *= 2.0 * robot.radius,
      robot.goal.x *= 2.0 * robot.radius;
      scene.robots.push_back(robot);
    }
    Simulation simulation(scene, 1);
    float most = 0.0F;
    for (int k = 0; k < 400; ++k) {
      simulation.step();
      for (const Detour& detour : simulation.fleet().detour) most = std::max(most, detour.beside);
      ASSERT_EQ(test::refusal([&] { Simulation(simulation.save(), 1); }), "") << "step " << k;
    }
    EXPECT_LE(most, 200.0F);
    EXPECT_GT(most, 180.0F) << max_speed;
  }
}

}  // namespace
}  // namespace avo
