// SPDX-License-Identifier: Apache-2.0
// A player walks through a crowd of 2000 robots, as a game steers it. The player is a robot that
// the host moves, and the others evade it. In the end it stops, and decides again.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include <avo/avo.h>

int main() {
  avo::Scenario scene;
  for (int k = 0; k < 2000; ++k) {  // robots cross a square to and fro
    avo::RobotSetup robot;
    robot.radius = 0.3;
    robot.position = {2.0 * (k % 50) - 49.0, 2.0 * (k / 50) - 39.0};
    robot.goal = {-robot.position.x, robot.position.y};
    scene.robots.push_back(robot);
  }
  constexpr avo::Vec2 kStart{0, -44};
  avo::RobotSetup own;
  own.position = own.goal = kStart;
  own.radius = 0.4;                           // m
  own.max_acceleration = 2.5;                 // m/s^2, that it may speed up, brake and turn
  own.max_speed = own.preferred_speed = 1.5;  // m/s
  scene.robots.push_back(own);
  const avo::RobotId player{2000};
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);

  const auto begin = std::chrono::steady_clock::now();
  constexpr int kFrames = 400;
  for (int frame = 0; frame < kFrames; ++frame) {
    const double direction = 0.6 * std::sin(0.03 * frame);  // rad, from a joystick
    const double speed = std::min(0.2 * frame, 1.4);        // m/s
    simulation.set_velocity(player,
                            avo::Vec2{speed * std::sin(direction), speed * std::cos(direction)});
    simulation.step();
    metrics.observe(simulation);
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  const avo::RunSummary summary = metrics.summary();
  const double way = simulation.robot(player).position.y - kStart.y;  // m
  std::printf("the player went %.0f m, touched %d robots in motion; %d pairs of robots touched\n",
              way, int(summary.one_sided_collisions_in_motion), int(summary.collision_pairs));
  const double end = simulation.time();
  simulation.set_velocity(player, std::nullopt);
  while (!simulation.decided(player) && simulation.can_step_by(end + 10.0)) simulation.step();
  std::printf("it decides again after %.1f s\n", simulation.time() - end);
  std::printf("%.1f ms a frame, metrics included\n", spent.count() / kFrames);
  const bool is_safe = summary.one_sided_collisions_in_motion == 0 && summary.collision_pairs == 0;
  return is_safe && way > 40.0 && simulation.decided(player) ? 0 : 1;
}
