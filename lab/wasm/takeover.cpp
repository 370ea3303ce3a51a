// SPDX-License-Identifier: Apache-2.0
// A text changes while its scene runs: the changes take effect, and everything else continues.
#include <algorithm>
#include <cstddef>

#include "host.h"

namespace avo_lab {
namespace {

/// Sets the robot of the text to its place in the running scene. `was`: the robot in the previous
/// text; null if it was not there.
void go_on(avo::RobotSetup& robot, const avo::RobotSetup* was, std::size_t index) {
  const avo::Simulation& now = *plane().simulation;
  const avo::FleetView fleet = now.fleet();
  if (!was || was->goal == robot.goal) robot.goal = fleet.goal[index];
  const bool same_start =
      !was || (was->position == robot.position && was->velocity == robot.velocity &&
               was->heading == robot.heading);
  if (now.steps() > 0 || same_start) {
    robot.position = fleet.position[index];
    robot.velocity = fleet.velocity[index];
    robot.heading = is_holonomic(robot.model) ? 0.0 : fleet.heading[index];
  }
  if (is_parked(robot)) robot.goal = robot.position, robot.velocity = {};
}

/// Returns whether the obstacle continues from its present place.
bool goes_on(const avo::MovingObstacle& text, const avo::MovingObstacle* was) {
  return plane().simulation->steps() > 0 || !was ||
         (was->position == text.position && was->velocity == text.velocity);
}

std::size_t number_of(avo::RobotId robot) {
  return static_cast<std::size_t>(robot.value);
}

template <class Setup>
const Setup* at(const std::vector<Setup>& setups, std::size_t index) {
  return index < setups.size() ? &setups[index] : nullptr;
}

}  // namespace

Takeover taken_over_by(const avo::Scenario& text) {
  const avo::Scenario& was = plane().scenario;
  const avo::FleetView fleet = plane().simulation->fleet();
  Takeover next{.start = text};
  std::vector<avo::RobotSetup>& robots = next.start.robots;
  const std::size_t listed = robots.size();
  // one more than the largest number of this run, of robots of the text or of later robots
  std::size_t given = was.robots.size();
  if (!fleet.id.empty()) given = std::max(given, number_of(fleet.id.back()) + 1);
  std::vector<bool> is_gone(std::max(given, listed));
  std::fill_n(is_gone.begin(), given, true);
  for (std::size_t k = 0; k < fleet.id.size(); ++k) {
    const std::size_t number = number_of(fleet.id[k]);
    if (number >= listed && number < was.robots.size()) continue;  // the text has dropped it
    if (number >= robots.size()) robots.resize(number + 1, fleet.setup[k]);
    is_gone[number] = false;
    if (number >= listed) robots[number] = fleet.setup[k];
    go_on(robots[number], at(was.robots, number), k);
  }
  for (std::size_t number = 0; number < robots.size(); ++number)
    if (is_gone[number]) next.gone.push_back({number});
  const avo::MovingObstacleView movers = plane().simulation->moving_obstacles();
  std::vector<avo::MovingObstacle>& obstacles = next.start.moving_obstacles;
  for (std::size_t k = 0; k < std::min(movers.setup.size(), obstacles.size()); ++k) {
    next.goes_on.push_back(goes_on(obstacles[k], at(was.moving_obstacles, k)));
    if (!next.goes_on.back()) continue;
    obstacles[k].position = movers.position[k];
    obstacles[k].velocity = movers.velocity[k];
  }
  return next;
}

}  // namespace avo_lab
