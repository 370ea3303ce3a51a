// SPDX-License-Identifier: Apache-2.0
#include "space/shared_goals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace avo::space {
namespace {

constexpr double kTouching = 1e-9;  // of contact: goals that touch leave room for both

// Returns whether neither of two robots can be at its goal while the other one is, or only one.
bool overlap(const Robot& a, Vec3 goal_a, const Robot& b, Vec3 goal_b) {
  Vec3 away = goal_a - goal_b;
  away.z -= std::clamp(away.z, -b.downwash, a.downwash);
  return norm(away) < (1.0 - kTouching) * (a.radius + b.radius);
}

}  // namespace

std::vector<SpaceShares> shared_goals(std::span<const Robot> robots, std::span<const Vec3> goals) {
  std::vector<std::size_t> order(robots.size());
  double largest = 0.0;  // m
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = k, largest = std::max(largest, robots[k].radius);
  const auto place = [&](std::size_t k) { return std::tuple(goals[k].x, goals[k].y, goals[k].z); };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  std::vector<SpaceShares> shares;
  const auto note = [&](std::size_t k, SpaceShares found) {
    shares.resize(robots.size());
    shares[k] = std::max(shares[k], found);
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const std::size_t b = order[j];
      if (goals[b].x - goals[a].x >= robots[a].radius + largest) break;
      const SpaceShares found = goals[a] == goals[b] ? SpaceShares::goal : SpaceShares::room;
      if (overlap(robots[a], goals[a], robots[b], goals[b])) note(a, found), note(b, found);
    }
  }
  return shares;
}

}  // namespace avo::space
