// SPDX-License-Identifier: Apache-2.0
// A player walks through a crowd of 2000 robots, as a game steers it. The robots evade the player.
#include <chrono>
#include <cmath>
#include <cstdio>

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
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);

  avo::MovingObstacle player;
  player.position = {0, -44};
  player.radius = 0.4;         // m
  player.max_deviation = 2.5;  // m/s^2, that it may speed up, brake and turn
  player.max_speed = 1.5;      // m/s
  const avo::MovingObstacleId id = simulation.add_moving_obstacle(player);

  const auto begin = std::chrono::steady_clock::now();
  constexpr int kFrames = 400;
  for (int frame = 0; frame < kFrames; ++frame) {
    const double wanted = 0.6 * std::sin(0.03 * frame);  // rad, from a joystick
    player.position = simulation.moving_obstacles().position[0];
    player.velocity = {1.4 * std::sin(wanted), 1.4 * std::cos(wanted)};
    simulation.change_moving_obstacle(id, player);
    simulation.step();
    metrics.observe(simulation);
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  const avo::RunSummary summary = metrics.summary();
  std::printf("the player went %.0f m, touched %d robots in motion; %d pairs of robots touched\n",
              simulation.moving_obstacles().position[0].y + 44.0,
              int(summary.mover_collisions_in_motion), int(summary.collision_pairs));
  std::printf("%.1f ms a frame, metrics included\n", spent.count() / kFrames);
}
