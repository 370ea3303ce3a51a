// SPDX-License-Identifier: Apache-2.0
#include "check/crowd.h"

#include <algorithm>
#include <vector>

namespace avo::judge {
namespace {

double apart(const CheckedRobot& /*a*/, Vec2 at_a, const CheckedRobot& /*b*/, Vec2 at_b) {
  return norm(at_a - at_b);
}

double apart(const space::CheckedRobot& a, Vec3 at_a, const space::CheckedRobot& b, Vec3 at_b) {
  Vec3 away = at_a - at_b;
  away.z -= std::clamp(away.z, -b.downwash, a.downwash);
  return norm(away);
}

template <typename Vec, typename Robot>
bool rests(std::size_t robot, Vec goal, std::span<const Robot> robots,
           std::span<const std::optional<Vec>> places) {
  if (!places[robot] || !robots[robot].goal) return false;
  const double radius = robots[robot].radius;
  const auto from_goal = [&](std::size_t k) {
    return apart(robots[robot], goal, robots[k], *places[k]);
  };
  const auto stands_on_goal = [&](std::size_t k) {
    const double contact = radius + robots[k].radius;
    return k != robot && places[k] && robots[k].goal &&
           apart(robots[robot], *robots[robot].goal, robots[k], *robots[k].goal) < contact &&
           from_goal(k) < contact;
  };
  // robots that are led to, the nearest to the goal last
  std::vector<std::size_t> left, led{robot};
  bool is_taken = false;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    is_taken = is_taken || stands_on_goal(k);
    if (k != robot && places[k]) left.push_back(k);
  }
  while (is_taken && !led.empty()) {
    const std::size_t one = led.back();
    led.pop_back();
    if (stands_on_goal(one)) return true;
    const auto is_apart = [&](std::size_t k) {
      return apart(robots[k], *places[k], robots[one], *places[one]) >=
             robots[one].radius + robots[k].radius + 2.0 * radius;
    };
    const auto close = std::partition(left.begin(), left.end(), is_apart);
    led.insert(led.end(), close, left.end());
    left.erase(close, left.end());
    std::sort(led.begin(), led.end(),
              [&](std::size_t a, std::size_t b) { return from_goal(a) > from_goal(b); });
  }
  return false;
}

}  // namespace

bool rests_at_crowd(std::size_t robot, Vec2 goal, std::span<const CheckedRobot> robots,
                    std::span<const std::optional<Vec2>> places) {
  return rests<Vec2>(robot, goal, robots, places);
}

bool rests_at_crowd(std::size_t robot, Vec3 goal, std::span<const space::CheckedRobot> robots,
                    std::span<const std::optional<Vec3>> places) {
  return rests<Vec3>(robot, goal, robots, places);
}

std::vector<std::optional<Vec3>> places_at_rest(std::size_t robots,
                                                std::span<const space::CheckedState> rows) {
  std::vector<std::optional<Vec3>> places(robots);
  for (const space::CheckedState& row : rows)
    if (row.velocity == Vec3{}) places[static_cast<std::size_t>(row.robot)] = row.position;
  return places;
}

}  // namespace avo::judge
