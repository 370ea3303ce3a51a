// SPDX-License-Identifier: Apache-2.0
// Which of two robots must keep clear of the other: by their layers, and whether they are parked.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "avo/check.h"

namespace avo::judge {

inline bool avoids(const CheckedRobot& a, const CheckedRobot& b) {
  if (a.parked || b.parked) return a.parked != b.parked;
  return (a.avoids & b.layers) != 0;
}

/// Which robots of a pair must keep clear of the other.
enum class Duty : unsigned char { nobody, first, second, both };
inline Duty duty(const CheckedRobot& a, const CheckedRobot& b) {
  if (avoids(a, b)) return avoids(b, a) ? Duty::both : Duty::first;
  return avoids(b, a) ? Duty::second : Duty::nobody;
}

/// One robot of each kind; robots of one kind are equal for duty(). With too many kinds, some are
/// assumed to avoid each other.
struct DutyKinds {
  static constexpr std::size_t kMost = 256;
  std::vector<CheckedRobot> robots;
  bool mutual = false;  // there may be a pair in which both avoid the other

  void add(const CheckedRobot& robot) {
    if (mutual) return;
    mutual = robots.size() >= kMost ||
             std::any_of(robots.begin(), robots.end(), [&](const CheckedRobot& other) {
               return duty(robot, other) == Duty::both;
             });
    const bool known = std::any_of(robots.begin(), robots.end(), [&](const CheckedRobot& other) {
      return other.layers == robot.layers && other.avoids == robot.avoids &&
             other.parked == robot.parked;
    });
    if (!known) robots.push_back(robot);
  }
};

}  // namespace avo::judge
