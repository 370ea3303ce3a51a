// SPDX-License-Identifier: Apache-2.0
#include "check/crowd.h"

#include <algorithm>
#include <vector>

namespace avo::judge {

bool rests_at_crowd(std::size_t robot, Vec2 goal, std::span<const CheckedRobot> robots,
                    std::span<const std::optional<Vec2>> places) {
  if (!places[robot] || !robots[robot].goal) return false;
  const double radius = robots[robot].radius;
  const auto from_goal = [&](std::size_t k) { return norm(*places[k] - goal); };
  const auto stands_on_goal = [&](std::size_t k) {
    const double contact = radius + robots[k].radius;
    return k != robot && places[k] && robots[k].goal &&
           norm(*robots[k].goal - *robots[robot].goal) < contact && from_goal(k) < contact;
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
      return norm(*places[k] - *places[one]) >=
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

}  // namespace avo::judge
