// SPDX-License-Identifier: Apache-2.0
// Robots that have not arrived, as they stand at the end of a run.
#include "metrics/not_arrived.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace avo {
namespace {

constexpr double kStands = 0.05;      // of the preferred speed: slower is no motion
constexpr double kTouching = 0.15;    // of the sum of radii: nearer than that, it holds
constexpr std::size_t kMostHeld = 5;  // named of those that hold one

}  // namespace

void LastSeen::look_at(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  robots.clear();
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    robots.push_back({.id = fleet.id[i],
                      .position = fleet.position[i],
                      .velocity = fleet.velocity[i],
                      .goal = fleet.goal[i],
                      .heading = fleet.heading[i],
                      .radius = fleet.setup[i].radius,
                      .status = fleet.plan[i].status,
                      .detour = fleet.detour[i].angle,
                      .layers = fleet.setup[i].layers,
                      .avoids = fleet.setup[i].avoids,
                      .parked = fleet.setup[i].parked,
                      .wait = {}});
    const bool is_at_rest = norm(fleet.velocity[i]) <= kStands * fleet.setup[i].preferred_speed;
    if (is_at_rest && !fleet.setup[i].parked && !simulation.is_at_goal(i))
      robots.back().wait = simulation.wait(i);
  }
  const ObstacleView seen = simulation.obstacles();
  obstacles.clear();
  for (std::size_t k = 0; k < seen.setup.size(); ++k) {
    obstacles.push_back({seen.position[k], seen.velocity[k], seen.setup[k].radius});
  }
}

NotArrived LastSeen::describe(std::size_t robot) const {
  const Robot& self = robots[robot];
  NotArrived result{.robot = self.id.value,
                    .distance = norm(self.goal - self.position),
                    .speed = norm(self.velocity),
                    .status = self.status,
                    .detour = self.detour,
                    .held_by = {},
                    .passage = {},
                    .distance_left = 0.0};
  std::vector<std::pair<double, std::int64_t>> near;  // m beyond contact, and who
  const auto consider = [&](Vec2 other, double other_radius, std::int64_t name) {
    const double contact = self.radius + other_radius;
    const double beyond = norm(other - self.position) - contact;
    if (beyond <= kTouching * contact) near.emplace_back(beyond, name);
  };
  for (const Robot& other : robots) {
    const bool minds = other.parked || (self.avoids.bits & other.layers.bits) != 0;
    if (&other == &self || !minds) continue;
    consider(other.position, other.radius, static_cast<std::int64_t>(other.id.value));
  }
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    consider(obstacles[k].position, obstacles[k].radius, -1 - static_cast<std::int64_t>(k));
  }
  std::sort(near.begin(), near.end());
  for (std::size_t k = 0; k < std::min(near.size(), kMostHeld); ++k) {
    result.held_by.push_back(near[k].second);
  }
  if (self.wait) {
    const auto other = static_cast<std::int64_t>(self.wait->robot.value);
    std::vector<std::int64_t>& held_by = result.held_by;
    if (std::find(held_by.begin(), held_by.end(), other) == held_by.end()) held_by.push_back(other);
    result.passage = self.wait->passage;
  }
  return result;
}

}  // namespace avo
