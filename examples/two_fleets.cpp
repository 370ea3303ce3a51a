// SPDX-License-Identifier: Apache-2.0
// Two fleets in one hall, of two makers: one decides by avo, the other one by ORCA. Both go to the
// other side and back, and the program compares them.
#include <array>
#include <cstdio>
#include <vector>

#include <avo/avo.h>

namespace {

constexpr int kOfEach = 10;

struct Fleet {
  const char* name;
  avo::Method method;
  double sum = 0.0;  // s, of arrivals
  int arrived = 0;
  int touched = 0;  // pairs of this fleet
};

}  // namespace

int main() {
  std::array<Fleet, 2> fleets{{{"avo", avo::Method::avo}, {"orca", avo::Method::orca}}};
  avo::Scenario scene;
  for (int k = 0; k < 2 * kOfEach; ++k) {
    const double side = k / 2 % 2 == 0 ? -1.0 : 1.0;
    const int place = k / 4 * 2 + k % 2;  // of those on this side
    avo::RobotSetup robot;
    robot.method = fleets[k % 2].method;
    robot.radius = 0.35;
    robot.max_speed = robot.preferred_speed = 1.5;
    robot.position = {side * (9.0 + 1.6 * (place % 2)), 1.5 * (place / 2) - 3.7 + 0.1 * (k % 3)};
    robot.goal = {-robot.position.x, robot.position.y};
    scene.robots.push_back(robot);
  }
  avo::Simulation simulation(scene);
  std::vector<bool> is_there(2 * kOfEach), touches(4 * kOfEach * kOfEach);
  while (!simulation.all_at_goal() && simulation.can_step_by(90.0)) {
    simulation.step();
    const avo::FleetView now = simulation.fleet(avo::Columns::position);
    for (std::size_t a = 0; a < now.position.size(); ++a) {
      Fleet& own = fleets[a % 2];
      if (!is_there[a] && simulation.is_at_goal({a}))
        is_there[a] = true, ++own.arrived, own.sum += simulation.time();
      for (std::size_t b = a % 2; b < a; b += 2) {  // of the same fleet
        const bool overlap = norm(now.position[a] - now.position[b]) < 0.7 * (1.0 - 1e-9);
        if (overlap && !touches[a * 2 * kOfEach + b])
          touches[a * 2 * kOfEach + b] = true, ++own.touched;
      }
    }
  }
  for (const Fleet& fleet : fleets)
    std::printf("%-4s: %d of %d arrived, after %.1f s on average, %d pairs touched\n", fleet.name,
                fleet.arrived, kOfEach, fleet.arrived > 0 ? fleet.sum / fleet.arrived : 0.0,
                fleet.touched);
  const bool all = fleets[0].arrived == kOfEach && fleets[1].arrived == kOfEach;
  return all && fleets[0].touched == 0 ? 0 : 1;
}
