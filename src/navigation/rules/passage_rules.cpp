// SPDX-License-Identifier: Apache-2.0
#include "navigation/rules/passage_rules.h"

#include <utility>

namespace avo::inline navigation {
namespace {

constexpr double kBack = 2.5;       // from the mouth: the target of a robot that backs out
constexpr double kOut = 0.6;        // before the mouth: where it turns
constexpr double kBackAside = 2.0;  // to the side of the bay
constexpr double kBothFit = 1e-9;   // of contact: goals that touch leave room for both

}  // namespace

Mouth mouth_of(const Passage& passage, bool forward) {
  const AxisPoint start = axis_point(passage, forward, 0.0);
  const double side = passage.bay_side[forward ? 0 : 1];
  return {start.point, start.direction, -side * perpendicular(start.direction)};
}

bool comes_first(Vec2 p, Vec2 q) {
  return std::pair(p.x, p.y) < std::pair(q.x, q.y);
}

bool share_goal(const Claimant& a, const Claimant& b) {
  const double contact = (1.0 - kBothFit) * (a.room + b.room);
  return a.room > 0.0 && b.room > 0.0 && norm(b.goal - a.goal) < contact;
}

bool senses(const Claimant& robot, const Claimant& other, double sensing_radius) {
  return !(other.position == robot.position) && (robot.avoids & other.layers) != 0 &&
         !share_goal(robot, other) && norm(other.position - robot.position) <= sensing_radius;
}

bool rests_apart(const Passage& passage, const Claimant& robot, const Claimant& other) {
  return !other.claim.moves && norm(other.position - robot.position) > kRestsNear * passage.radius;
}

void Foremost::include(const Passage& passage, const Claimant& robot) {
  const double along = place_in(passage, robot.position).along;
  const double come = robot.claim.forward ? along : passage.length() - along;
  if (come > advance) advance = come, position = robot.position;
}

bool Foremost::goes_on_before(const Foremost& other) const {
  return advance > other.advance ||
         (advance == other.advance && comes_first(position, other.position));
}

Vec2 place_outside(const Passage& passage, bool forward, Vec2 position) {
  const Mouth mouth = mouth_of(passage, forward);
  const bool is_out = dot(position - mouth.center, mouth.inward) < kOut * passage.radius;
  const double aside = is_out ? kBackAside : 0.0;
  return mouth.center + passage.radius * (aside * mouth.aside - kBack * mouth.inward);
}

}  // namespace avo::inline navigation
