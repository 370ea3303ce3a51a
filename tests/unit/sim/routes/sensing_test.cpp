// SPDX-License-Identifier: Apache-2.0
// How far robots have to see: the bound suffices and is not larger than it must be; the speed that
// a sensing radius admits is its exact inverse.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "avo/assumptions.h"
#include "support/generators.h"
#include "unit/sim/certified_scenes.h"

namespace avo {
namespace {

using test::head_on;
using test::Kind;
using test::kKinds;
using test::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Kind kDefault{};

TEST(SensingNeed, radii_a_step_and_braking_of_the_two_that_need_most) {
  Scenario scene = head_on(20.0, kDefault);
  EXPECT_DOUBLE_EQ(sensing_need(scene)->range, 5.4);  // 2 (0.5 + 0.2 + 2)
  scene.sensing_radius = 5.4;
  EXPECT_TRUE(broken_assumptions(scene).none());
  EXPECT_EQ(admissible_speed(scene), kInfinity);
  scene.sensing_radius = 5.4 - 1e-9;
  const BrokenAssumptions broken = broken_assumptions(scene);
  EXPECT_EQ(broken.start_count + broken.fast_count, 0);
  ASSERT_TRUE(broken.unseen);
  EXPECT_EQ(broken.unseen->robot, RobotId{0});
  EXPECT_EQ(broken.unseen->other, BodyId(RobotId{1}));
  EXPECT_DOUBLE_EQ(broken.unseen->robot_part, 2.7);
  EXPECT_DOUBLE_EQ(broken.unseen->other_part, 2.7);

  for (int i = 2; i < 6; ++i) {
    scene.robots.push_back(scene.robots[0]);
    scene.robots.back().position = {0.0, 100.0 * i};
    scene.robots.back().max_speed = i == 3 ? 3.0 : 0.1 * i;
  }
  scene.robots[0].radius = 0.3;
  const SensingNeed need = *sensing_need(scene);  // 0.5 + 0.3 + 4.5 of robot 3
  EXPECT_EQ(need.robot, RobotId{1});
  EXPECT_EQ(need.other, BodyId(RobotId{3}));
  EXPECT_DOUBLE_EQ(need.robot_part, 2.7);
  EXPECT_DOUBLE_EQ(need.other_part, 5.3);
}

TEST(SensingNeed, one_robot_needs_to_see_nobody_but_obstacles) {
  Scenario scene = head_on(20.0, kDefault);
  scene.robots.pop_back();
  EXPECT_FALSE(sensing_need(scene));
  scene.sensing_radius = 1e-3;
  EXPECT_TRUE(broken_assumptions(scene).none());
  scene.duration = 10.0;
  scene.moving_obstacles = {{{50.0, 0.0}, {-1.0, 0.0}, {}, 0.4},
                            {{90.0, 0.0}, {-0.6, 0.0}, {-0.1, 0.0}, 0.4},   // 1.6 m/s at last
                            {{90.0, 50.0}, {2.0, 0.0}, {-0.1, 0.0}, 0.4}};  // 2 m/s at first
  const SensingNeed need = *sensing_need(scene);  // for one step and 21 of braking
  EXPECT_EQ(need.other, BodyId(MovingObstacleId{2}));
  EXPECT_DOUBLE_EQ(need.robot_part, 2.7);
  EXPECT_DOUBLE_EQ(need.other_part, 0.4 + 2.2 * 2.0 + 0.05 * 2.2 * 2.2);
  scene.moving_obstacles.pop_back();
  EXPECT_DOUBLE_EQ(sensing_need(scene)->other_part, 0.4 + 2.2 * 1.6 + 0.05 * 2.2 * 2.2);
  scene.moving_obstacles.pop_back();
  EXPECT_DOUBLE_EQ(sensing_need(scene)->other_part, 0.4 + 2.2);
  scene.motion = Motion::exponential;  // 0.0975 m/s a step: 21 again; its parabola is 0.8 Δt²/8 off
  scene.moving_obstacles[0] = {{90.0, 0.0}, {}, {0.8, 0.0}, 0.4};
  EXPECT_DOUBLE_EQ(sensing_need(scene)->other_part, 0.4 + 2.2 * 8.0 + 0.4 * 2.2 * 2.2 + 0.001);
}

TEST(SensingNeed, the_worst_of_all_robots_for_every_obstacle) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    Scenario scene;
    for (int i = 0; i < 30; ++i) {
      RobotSetup robot;
      robot.radius = random.log_uniform(0.1, 10.0);
      robot.max_speed = random.log_uniform(0.1, 10.0);
      robot.max_acceleration = random.log_uniform(0.1, 10.0);
      scene.robots.push_back(robot);
    }
    for (int k = 0; k < 5; ++k) {
      scene.moving_obstacles.push_back({{}, test::in_disc(random, 20.0), {}, 0.5});
    }
    double worst = 0.0;
    Scenario pair = scene;
    for (std::size_t i = 0; i < scene.robots.size(); ++i) {
      for (const MovingObstacle& obstacle : scene.moving_obstacles) {
        pair.robots = {scene.robots[i]};
        pair.moving_obstacles = {obstacle};
        worst = std::max(worst, sensing_need(pair)->range);
      }
      for (std::size_t j = 0; j < i; ++j) {
        pair.robots = {scene.robots[i], scene.robots[j]};
        pair.moving_obstacles.clear();
        worst = std::max(worst, sensing_need(pair)->range);
      }
    }
    EXPECT_DOUBLE_EQ(sensing_need(scene)->range, worst);
  }
}

TEST(AdmissibleSpeed, is_the_exact_inverse_of_the_need) {
  Random random(8);
  for (const Kind kind : kKinds) {
    for (int round = 0; round < 20; ++round) {
      Scenario scene = head_on(100.0, kind);
      scene.robots[1].max_acceleration = random.log_uniform(0.3, 3.0);
      scene.robots[0].max_speed = random.uniform(1.0, 3.0);
      scene.sensing_radius = 1.0 + random.uniform(0.05, 0.95) * (sensing_need(scene)->range - 1.0);
      const double speed = admissible_speed(scene);
      ASSERT_GT(speed, 0.0);
      ASSERT_LT(speed, 3.0);
      const auto is_seen = [&](double limit) {
        Scenario limited = scene;
        for (RobotSetup& robot : limited.robots) {
          robot.max_speed = std::min(robot.max_speed, limit);
          robot.velocity = {};
        }
        return broken_assumptions(limited).none();
      };
      EXPECT_TRUE(is_seen(speed));
      EXPECT_FALSE(is_seen(std::nextafter(speed, kInfinity)));
    }
  }
  Scenario scene = head_on(100.0, kDefault);
  for (const double speed : {0.05, 0.1, 0.73, 1.0, 1.9}) {  // below, at, between whole steps
    for (RobotSetup& robot : scene.robots) robot.max_speed = speed;
    scene.sensing_radius = sensing_need(scene)->range;
    for (RobotSetup& robot : scene.robots) robot.max_speed = 2.0;
    EXPECT_NEAR(admissible_speed(scene), speed, 1e-10);
  }
  scene.sensing_radius = 0.999;
  EXPECT_EQ(admissible_speed(scene), 0.0) << "the radii alone are more";
}

TEST(Remedies, start_at_rest_mends_starts_that_do_not_overlap) {
  for (const Kind kind : kKinds) {
    Scenario scene = head_on(1.5, kind);
    scene.robots.push_back(scene.robots[0]);
    scene.robots[2].position = {0.0, 50.0};
    scene.robots[2].velocity = {};
    scene.robots[0].velocity = {3.0, 0.0};
    EXPECT_FALSE(broken_assumptions(scene).none());
    EXPECT_EQ(start_at_rest(scene), 2);
    EXPECT_TRUE(broken_assumptions(scene).none());
    EXPECT_EQ(start_at_rest(scene), 0);
  }
}

TEST(Remedies, limit_speed_caps_exactly_those_above) {
  for (const Kind kind : kKinds) {
    Scenario scene = head_on(100.0, kind);
    scene.robots.push_back(scene.robots[0]);
    scene.robots[2].position = {0.0, 50.0};
    scene.robots[2].velocity = {0.2, 0.0};
    scene.robots[2].max_speed = 0.3;
    scene.robots[1].preferred_speed = 0.7;
    scene.sensing_radius = 4.0;
    const double speed = admissible_speed(scene);
    const LimitedSpeeds limited = limit_speed(scene);
    EXPECT_EQ(limited.robots, 2);
    EXPECT_EQ(limited.starts, 2);
    EXPECT_EQ(limited.limit, speed);
    EXPECT_EQ(scene.robots[0].max_speed, speed);
    EXPECT_EQ(scene.robots[0].preferred_speed, speed);
    EXPECT_EQ(scene.robots[1].preferred_speed, 0.7);
    EXPECT_NEAR(norm(scene.robots[0].velocity), speed, 1e-15);
    EXPECT_EQ(scene.robots[2].max_speed, 0.3);
    EXPECT_EQ(scene.robots[2].preferred_speed, 2.0);
    EXPECT_EQ(scene.robots[2].velocity, (Vec2{0.2, 0.0}));
    EXPECT_TRUE(broken_assumptions(scene).none());
    EXPECT_EQ(limit_speed(scene).robots, 0);
  }
}

TEST(Remedies, limit_speed_leaves_alone_what_it_cannot_mend) {
  Scenario scene = head_on(100.0, kDefault);
  scene.sensing_radius = 0.5;
  EXPECT_EQ(limit_speed(scene).robots, 0);
  EXPECT_EQ(scene.robots[0].max_speed, 2.0);
  scene.certificate = Certificate::none;
  scene.robots[0].velocity = {9.0, 0.0};
  const LimitedSpeeds limited = limit_speed(scene);
  EXPECT_EQ(limited.robots + limited.starts, 0);
  EXPECT_EQ(scene.robots[0].velocity, (Vec2{9.0, 0.0}));
}

}  // namespace
}  // namespace avo
