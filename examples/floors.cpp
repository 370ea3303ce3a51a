// SPDX-License-Identifier: Apache-2.0
// Two storeys above each other, and a lift. Robots queue for it on the ground, and go to their
// rooms upstairs: the host changes their layers while they stand in the lift.
#include <cstdio>
#include <vector>

#include <avo/avo.h>

namespace {

constexpr avo::LayerSet kGround{1}, kUpper{2};
constexpr int kRobots = 6;
constexpr avo::Vec2 kLift{0, 0};  // m, on both storeys

// Walls of the shaft are on both storeys, as a scene has them that says nothing of layers. The
// other walls stand where the other storey has ways.
std::vector<avo::StaticObstacle> building() {
  const avo::StaticObstacle shaft{{{{{1, -1}, {1, 1}}, false}}};
  const avo::StaticObstacle ground{.chains = {{{{-1, 1}, {-14, 1}, {-14, -1}, {-1, -1}}, false}},
                                   .layers = kGround};
  const avo::StaticObstacle upper{
      .chains = {{{{-5, -8}, {-5, -0.6}}, false}, {{{-5, 0.6}, {-5, 8}}, false}}, .layers = kUpper};
  return {shaft, ground, upper};
}

}  // namespace

int main() {
  avo::Scenario scene;
  scene.obstacles = building();
  std::vector<avo::RobotId> all;
  for (int k = 0; k < kRobots; ++k) {
    avo::RobotSetup robot;
    robot.radius = 0.3;
    robot.layers = robot.avoids = kGround;
    robot.position = {-3.0 - 1.5 * k, 0};
    robot.goal = {-10, 2.0 * k - 5.0};  // upstairs, behind a wall with a door
    all.push_back({scene.robots.size()});
    scene.robots.push_back(robot);
  }
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  avo::Team queue = avo::make_team(all, avo::Queue{.line = {kLift, {-14, 0}}, .spacing = 1.0});
  while (!(queue.members.empty() && simulation.all_at_goal()) && simulation.can_step_by(180.0)) {
    lead(simulation, queue);
    simulation.step();
    metrics.observe(simulation);
    if (queue.members.empty()) continue;
    const avo::RobotId first = queue.members.front().robot;
    avo::RobotSetup setup = simulation.setup(first);
    const bool is_above_free = simulation.is_free(kLift, 0.4, kUpper);
    if (norm(setup.position - kLift) > 0.2 || !is_above_free) continue;
    setup.layers = setup.avoids = kUpper;
    simulation.change_robot(first, setup);  // refused if a wall of that storey were in its way
    serve(simulation, queue);
  }
  const avo::RunSummary summary = metrics.summary();
  int upstairs = 0;
  for (std::size_t k = 0; k < simulation.size(); ++k)
    upstairs += simulation.is_at_goal({k}) && simulation.setup({k}).layers == kUpper ? 1 : 0;
  std::printf("%d of %d are in their rooms upstairs after %.1f s, %d touched a wall, %d pairs\n",
              upstairs, kRobots, simulation.time(), int(summary.static_collisions),
              int(summary.collision_pairs));
  const bool is_safe = summary.static_collisions == 0 && summary.collision_pairs == 0;
  return upstairs == kRobots && is_safe ? 0 : 1;
}
