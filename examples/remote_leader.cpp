// SPDX-License-Identifier: Apache-2.0
// A person drives the leader of a group by four keys, through a yard of pillars. The others follow.
// The keys say what the leader prefers: it passes the pillars by itself.
#include <algorithm>
#include <cstdio>
#include <string_view>
#include <vector>

#include <avo/avo.h>

namespace {

// One letter each half second: up, left, down, right; a dot: no key.
constexpr std::string_view kKeys = "ddddddddddwwwwwwwwwwddddddddddssssssssssdddddddd......";
constexpr int kStepsOfKey = 5;

avo::Vec2 wanted(char key) {
  constexpr double kSpeed = 1.2;  // m/s
  switch (key) {
    case 'w':
      return {0, kSpeed};
    case 'a':
      return {-kSpeed, 0};
    case 's':
      return {0, -kSpeed};
    case 'd':
      return {kSpeed, 0};
    default:
      return {0, 0};
  }
}

}  // namespace

int main() {
  avo::Scenario scene;
  for (int k = 0; k < 30; ++k)
    scene.obstacles.push_back({{{{{3.0 + 3.0 * (k % 6), 3.0 * (k / 6) - 4.4}}}}, 0.3});
  std::vector<avo::RobotId> group;
  for (int k = 0; k < 5; ++k) {
    avo::RobotSetup robot;
    robot.radius = 0.3;
    robot.position = robot.goal = {-1.2 * k, 0};
    group.push_back({scene.robots.size()});
    scene.robots.push_back(robot);
  }
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  avo::Team team = avo::make_team(group, avo::Follow{.spacing = 1.0});
  for (const char key : kKeys) {
    for (int step = 0; step < kStepsOfKey; ++step) {
      lead(simulation, team);
      simulation.set_preferred_velocity(group.front(), wanted(key));
      simulation.step();
      metrics.observe(simulation);
    }
  }
  const avo::Vec2 leader = simulation.robot({0}).position;
  double farthest = 0.0;  // m, of the others from their leader
  for (std::size_t k = 1; k < simulation.size(); ++k)
    farthest = std::max(farthest, norm(simulation.robot({k}).position - leader));
  const avo::RunSummary summary = metrics.summary();
  std::printf(
      "driven to (%.1f, %.1f), the last one is %.1f m behind, %d pairs touched, %d pillars\n",
      leader.x, leader.y, farthest, int(summary.collision_pairs), int(summary.static_collisions));
  const bool is_safe = summary.collision_pairs == 0 && summary.static_collisions == 0;
  return is_safe && leader.x > 14.0 && farthest < 6.0 ? 0 : 1;
}
