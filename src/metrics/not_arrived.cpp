// SPDX-License-Identifier: Apache-2.0
// Robots that have not arrived, as they stand at the end of a run.
#include "metrics/not_arrived.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace avo {
namespace {

constexpr double kTouching = 0.1;     // of the sum of radii: nearer than that, it holds
constexpr std::size_t kMostHeld = 5;  // named of those that hold one

template <typename T, typename Part>
void assign(std::vector<T>& column, const FleetView& fleet, Part&& part) {
  column.clear();
  for (std::size_t i = 0; i < fleet.id.size(); ++i) column.push_back(part(i));
}

}  // namespace

void LastSeen::look_at(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  id.assign(fleet.id.begin(), fleet.id.end());
  position.assign(fleet.position.begin(), fleet.position.end());
  velocity.assign(fleet.velocity.begin(), fleet.velocity.end());
  goal.assign(fleet.goal.begin(), fleet.goal.end());
  assign(radius, fleet, [&](std::size_t i) { return fleet.setup[i].radius; });
  assign(status, fleet, [&](std::size_t i) { return fleet.plan[i].status; });
  assign(detour, fleet, [&](std::size_t i) { return fleet.detour[i].angle; });
  const ObstacleView obstacles = simulation.obstacles();
  obstacle_position.assign(obstacles.position.begin(), obstacles.position.end());
  obstacle_velocity.assign(obstacles.velocity.begin(), obstacles.velocity.end());
  obstacle_radius.clear();
  for (const MovingObstacle& obstacle : obstacles.setup) obstacle_radius.push_back(obstacle.radius);
}

NotArrived LastSeen::describe(std::size_t robot) const {
  NotArrived result{id[robot].value,       norm(goal[robot] - position[robot]),
                    norm(velocity[robot]), status[robot],
                    detour[robot],         {}};
  std::vector<std::pair<double, std::int64_t>> near;  // m beyond contact, and who
  const auto consider = [&](Vec2 other, double other_radius, std::int64_t name) {
    const double contact = radius[robot] + other_radius;
    const double beyond = norm(other - position[robot]) - contact;
    if (beyond <= kTouching * contact) near.emplace_back(beyond, name);
  };
  for (std::size_t j = 0; j < id.size(); ++j) {
    if (j != robot) consider(position[j], radius[j], static_cast<std::int64_t>(id[j].value));
  }
  for (std::size_t k = 0; k < obstacle_radius.size(); ++k) {
    consider(obstacle_position[k], obstacle_radius[k], -1 - static_cast<std::int64_t>(k));
  }
  std::sort(near.begin(), near.end());
  for (std::size_t k = 0; k < std::min(near.size(), kMostHeld); ++k) {
    result.held_by.push_back(near[k].second);
  }
  return result;
}

}  // namespace avo
