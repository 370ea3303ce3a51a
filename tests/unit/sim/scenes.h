// SPDX-License-Identifier: Apache-2.0
// Dense scenes without two equal distances, so that no tie is broken by index.
#pragma once
#include <cmath>
#include <numbers>

#include "avo/scenario.h"
#include "support/generators.h"

namespace avo::test {

inline RobotSetup robot_at(Vec2 position, Vec2 goal) {
  RobotSetup setup;
  setup.position = position;
  setup.goal = goal;
  return setup;
}

/// A scene of the paper's method: δ 4 s, τ 10 s.
inline Scenario paper_scene() {
  Scenario scene;
  scene.method = Method::avo_paper;
  return scene;
}

/// There are `count` robots of mixed sizes and limits on a jittered lattice 1.6 m wide, and every
/// fifth is a car. They drive to random goals in the crowd, and three moving obstacles pass through
/// it.
inline Scenario dense_scene(int count, Motion motion, std::uint64_t seed = 1) {
  Random random(seed);
  Scenario scene = paper_scene();
  scene.motion = motion;
  scene.control_time = 2.0;
  scene.time_horizon = 5.0;
  scene.sensing_radius = 8.0;
  scene.max_neighbors = 10;
  scene.allow_broken_assumptions = true;  // of a certificate that somebody adds
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  const double extent = 1.6 * side;
  for (int k = 0; k < count; ++k) {
    const Vec2 jitter{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
    const Vec2 place{1.6 * (k % side), 1.6 * (k / side)};
    RobotSetup setup =
        robot_at(place + jitter, {random.uniform(0.0, extent), random.uniform(0.0, extent)});
    setup.radius = random.uniform(0.3, 0.55);
    setup.max_speed = random.uniform(1.0, 2.0);
    setup.max_acceleration = random.uniform(0.5, 2.0);
    setup.preferred_speed = random.uniform(0.7, 1.0) * setup.max_speed;
    setup.velocity = in_disc(random, setup.max_speed);
    if (k % 5 == 0) {
      setup.model = Car{0.7}, setup.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
    }
    scene.robots.push_back(setup);
  }
  scene.moving_obstacles = {{{-3.1, 4.3}, {1.1, 0.2}, {}, 0.7},
                            {{extent + 2, 7.7}, {-0.8, 0.1}, {0.03, 0.0}, 0.4},
                            {{9.9, -2.2}, {0.05, 1.3}, {0.0, -0.05}, 0.6}};
  return scene;
}

/// The same by method avo, without cars. Some pairs start too near and too fast to keep apart.
inline Scenario dense_avo_scene(int count, Motion motion, Certificate certificate,
                                std::uint64_t seed = 1) {
  Scenario scene = dense_scene(count, motion, seed);
  scene.method = Method::avo;
  scene.certificate = certificate;
  for (RobotSetup& robot : scene.robots) robot.model = Holonomic{};
  return scene;
}

/// Motions and certificates that go together.
struct AvoKind {
  Motion motion;
  Certificate certificate;
};
inline constexpr AvoKind kAvoKinds[] = {
    {Motion::held, Certificate::braking_trajectories},
    {Motion::exponential, Certificate::braking_trajectories},
};

}  // namespace avo::test
