// SPDX-License-Identifier: Apache-2.0
// Robots that have not arrived, in their states at the end of a run.
#include "metrics/not_arrived.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace avo::inline metrics {
namespace {

constexpr double kStands = 0.05;      // of the preferred speed: a slower robot is not in motion
constexpr double kTouching = 0.15;    // of the sum of radii: a nearer body holds the robot
constexpr std::size_t kMostHeld = 5;  // number of bodies named that hold a robot

}  // namespace

void LastSeen::look_at(const Simulation& simulation, const FleetView& fleet) {
  robots.resize(fleet.id.size());
  wait.clear(), waiting.clear();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    robots[i] = {fleet.id[i],      fleet.position[i],     fleet.velocity[i],   fleet.goal[i],
                 fleet.heading[i], fleet.detour[i].angle, fleet.plan[i].status};
    const bool is_at_rest = norm(fleet.velocity[i]) <= kStands * fleet.setup[i].preferred_speed;
    if (!is_at_rest || is_parked(fleet.setup[i]) || simulation.is_at_goal(fleet.id[i])) continue;
    if (const auto waits = simulation.wait(fleet.id[i]))
      wait.push_back(*waits), waiting.push_back(i);
  }
  const MovingObstacleView seen = simulation.moving_obstacles();
  movers.clear();
  for (std::size_t k = 0; k < seen.setup.size(); ++k) {
    movers.push_back({seen.id[k].value, seen.position[k], seen.velocity[k], seen.setup[k].radius});
  }
}

NotArrived LastSeen::describe(std::size_t robot, std::span<const RobotSetup> setups) const {
  const RobotSetup& self = setups[robot];
  const LastRobot& own = robots[robot];
  NotArrived result{.robot = own.id.value,
                    .distance = norm(own.goal - own.position),
                    .speed = norm(own.velocity),
                    .status = own.status,
                    .detour_angle = own.detour,
                    .held_by = {},
                    .passage = {},
                    .distance_left = 0.0};
  std::vector<std::pair<double, std::int64_t>> near;  // m beyond contact, and the name
  const auto consider = [&](Vec2 other, double other_radius, std::int64_t name) {
    const double contact = self.radius + other_radius;
    const double beyond = norm(other - own.position) - contact;
    if (beyond <= kTouching * contact) near.emplace_back(beyond, name);
  };
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (i == robot || !avoids(self, setups[i])) continue;
    consider(robots[i].position, setups[i].radius, static_cast<std::int64_t>(robots[i].id.value));
  }
  for (std::size_t k = 0; k < movers.size(); ++k) {
    consider(movers[k].position, movers[k].radius, -1 - static_cast<std::int64_t>(movers[k].id));
  }
  std::sort(near.begin(), near.end());
  for (std::size_t k = 0; k < std::min(near.size(), kMostHeld); ++k) {
    result.held_by.push_back(near[k].second);
  }
  const auto place = std::lower_bound(waiting.begin(), waiting.end(), robot);
  if (place != waiting.end() && *place == robot) {
    const Simulation::Wait& waits = wait[static_cast<std::size_t>(place - waiting.begin())];
    const auto other = static_cast<std::int64_t>(waits.robot.value);
    std::vector<std::int64_t>& held_by = result.held_by;
    if (std::find(held_by.begin(), held_by.end(), other) == held_by.end()) held_by.push_back(other);
    result.passage = waits.passage;
  }
  return result;
}

}  // namespace avo::inline metrics
