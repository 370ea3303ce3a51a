// SPDX-License-Identifier: Apache-2.0
#include "check/crowd.h"

#include <algorithm>
#include <cstdint>
#include <optional>
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
           std::span<const std::optional<Vec>> places, std::span<const std::uint8_t> has_come) {
  if (!places[robot] || !robots[robot].goal) return false;
  const double radius = robots[robot].radius;
  const auto from_goal = [&](std::size_t k) {
    return apart(robots[robot], goal, robots[k], *places[k]);
  };
  const auto stands_on_goal = [&](std::size_t k) {
    const double contact = radius + robots[k].radius;
    if (k == robot || !places[k] || !robots[k].goal || !(from_goal(k) < contact)) return false;
    return has_come[k] != 0 ||
           apart(robots[robot], *robots[robot].goal, robots[k], *robots[k].goal) < contact;
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

// A robot that rests around its goal may stand on the goal of a third one.
template <typename Vec, typename Robot>
std::vector<std::uint8_t> rest_all(std::span<const Robot> robots, std::span<const Vec> goals,
                                   std::span<const std::optional<Vec>> places,
                                   std::span<const std::uint8_t> at_goal) {
  std::vector<std::uint8_t> has_come(at_goal.begin(), at_goal.end()), found(robots.size());
  for (bool looks = true; looks;) {
    looks = false;
    for (std::size_t k = 0; k < robots.size(); ++k) {
      if (has_come[k] != 0 || !rests<Vec>(k, goals[k], robots, places, has_come)) continue;
      has_come[k] = found[k] = 1;
      looks = true;
    }
  }
  return found;
}

}  // namespace

std::vector<std::uint8_t> rest_at_crowds(std::span<const CheckedRobot> robots,
                                         std::span<const Vec2> goals,
                                         std::span<const std::optional<Vec2>> places,
                                         std::span<const std::uint8_t> at_goal) {
  return rest_all(robots, goals, places, at_goal);
}

std::vector<std::uint8_t> rest_at_crowds(std::span<const space::CheckedRobot> robots,
                                         std::span<const std::optional<Vec3>> places,
                                         std::span<const std::uint8_t> at_goal) {
  std::vector<Vec3> goals;
  for (const space::CheckedRobot& robot : robots) goals.push_back(robot.goal.value_or(Vec3{}));
  return rest_all<Vec3>(robots, goals, places, at_goal);
}

std::vector<std::optional<Vec3>> places_at_rest(std::size_t robots,
                                                std::span<const space::CheckedState> rows) {
  std::vector<std::optional<Vec3>> places(robots);
  for (const space::CheckedState& row : rows)
    if (row.velocity == Vec3{}) places[static_cast<std::size_t>(row.robot)] = row.position;
  return places;
}

}  // namespace avo::judge
