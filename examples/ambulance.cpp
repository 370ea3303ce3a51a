// SPDX-License-Identifier: Apache-2.0
// An ambulance crosses a crowd of 160 walkers that cross each other, without priority and with it.
#include <cstdio>

#include <avo/avo.h>

namespace {

// s, until the ambulance has crossed; -1: a pair touched, or it did not arrive.
double crossing(double priority) {
  avo::Scenario scene;
  for (int k = 0; k < 160; ++k) {  // two streams, from the south and from the north
    const double side = k % 2 == 0 ? -1.0 : 1.0;
    avo::RobotSetup walker;
    walker.radius = 0.3;
    walker.max_speed = walker.preferred_speed = 1.4;
    walker.position = {2.1 * (k / 2 % 10) - 9.5 + 0.5 * side, side * (4.0 + 1.9 * (k / 20))};
    walker.goal = {walker.position.x, -walker.position.y};
    scene.robots.push_back(walker);
  }
  avo::RobotSetup ambulance;
  ambulance.radius = 0.9;
  ambulance.max_speed = ambulance.preferred_speed = 2.5;
  ambulance.priority = priority;
  ambulance.position = {-16, 0}, ambulance.goal = {16, 0};
  scene.robots.push_back(ambulance);
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  const avo::RobotId own{scene.robots.size() - 1};
  while (!simulation.is_at_goal(own) && simulation.can_step_by(120.0)) {
    simulation.step();
    metrics.observe(simulation);
  }
  const bool is_safe = metrics.summary().collision_pairs == 0;
  return simulation.is_at_goal(own) && is_safe ? simulation.time() : -1.0;
}

}  // namespace

int main() {
  const double alike = crossing(1.0), first = crossing(1000.0);
  std::printf("the ambulance crosses in %.1f s as one of all, in %.1f s with priority\n", alike,
              first);
  return first > 0.0 && alike > 0.0 && first < 0.9 * alike ? 0 : 1;
}
