// SPDX-License-Identifier: Apache-2.0
// Rule 8 of docs/arrival.md, wait beside the mouth. A robot that may not enter keeps off the path
// of robots that come out. In the area before the mouth the robot goes to the bay. Outside of this
// area it stops at the border.
#include <algorithm>
#include <cmath>

#include "navigation/rules/passage_rules.h"

namespace avo::inline navigation {
namespace {

constexpr double kDeep = 6.0;   // outward depth of the area before a mouth that is kept clear
constexpr double kAside = 1.6;  // and its width from the axis to the side of the bay
constexpr double kQueue = 2.2;  // beside the entrance, from the mouth: no robot waits nearer

}  // namespace

Course wait_beside(const Passage& passage, const Claimant& robot, double braking) {
  const double unit = passage.radius;
  const Mouth mouth = mouth_of(passage, robot.claim.forward);
  const Vec2 from_mouth = robot.position - mouth.center;
  const double out = -dot(from_mouth, mouth.inward), aside = dot(from_mouth, mouth.aside);
  const bool is_beside = aside >= kAside * unit;
  if (out < kDeep * unit && !is_beside) {
    const Vec2 bay = mouth.center - std::max(out, kBayOut * unit) * mouth.inward +
                     kBayAside * unit * mouth.aside;
    return {.target = bay, .stops = true};
  }
  const double behind = out - kDeep * unit;
  const double beside = is_beside ? robot.claim.distance - kQueue * unit : 0.0;
  const double room = std::max({0.0, behind, beside});
  return {.max_speed = std::sqrt(2.0 * braking * room)};
}

}  // namespace avo::inline navigation
