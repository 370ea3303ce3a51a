// SPDX-License-Identifier: Apache-2.0
// Writes a log of what happens to robots, with the reason where one stands, and does something
// about it: a parked robot that blocks the only door is sent away.
#include <cstdio>

#include <avo/avo.h>

int main() {
  avo::Scenario scene;  // a room, whose only door is 1.4 m wide
  scene.obstacles = {{{{{{10, -0.7}, {10, -5}, {20, -5}, {20, 5}, {10, 5}, {10, 0.7}}, false}}}};
  for (int k = 0; k < 5; ++k) {
    avo::RobotSetup robot;
    robot.radius = 0.4;
    robot.position = {-2.0 - 1.5 * k, 0.2 * (k % 2)};
    robot.goal = {18.0 - 1.6 * k, 2.5 - 1.2 * k};
    scene.robots.push_back(robot);
  }
  avo::RobotSetup cleaner;  // it stands in the door
  cleaner.radius = 0.4;
  cleaner.position = cleaner.goal = {10, 0};
  scene.robots.push_back(cleaner);
  const avo::RobotId blocking{5};
  avo::Simulation simulation(scene);
  avo::Events events(simulation);
  int stuck = 0, unreachable = 0, arrived = 0;
  const auto park = [&](bool is_parked) {
    avo::RobotSetup setup = simulation.setup(blocking);
    setup.behavior = is_parked ? avo::Behavior::parked : avo::Behavior::decides;
    simulation.change_robot(blocking, setup);
  };
  bool is_parked = false;
  while (!simulation.all_at_goal() && simulation.can_step_by(90.0)) {
    if (!is_parked && simulation.time() > 2.0) park(is_parked = true);  // its battery is empty
    if (is_parked && unreachable > 0 && simulation.time() > 14.0) {     // it is charged again
      park(false);
      simulation.set_goal(blocking, {6, 6});
      unreachable = -unreachable;
    }
    simulation.step();
    for (const avo::Event& event : events.observe(simulation)) {
      stuck += event.kind == avo::EventKind::stuck ? 1 : 0;
      unreachable += event.kind == avo::EventKind::unreachable ? 1 : 0;
      arrived += event.kind == avo::EventKind::arrived ? 1 : 0;
      std::printf("%5.1f s  robot %llu %s%s%s\n", simulation.time(),
                  static_cast<unsigned long long>(event.robot.value), to_string(event.kind),
                  event.sentence.empty() ? "" : ": ", event.sentence.c_str());
    }
  }
  std::printf("%d times a robot was stuck, %d goals were out of reach, %s\n", stuck, -unreachable,
              simulation.all_at_goal() ? "and all robots are there" : "and some are not there");
  return simulation.all_at_goal() && unreachable < 0 && arrived >= 6 ? 0 : 1;
}
