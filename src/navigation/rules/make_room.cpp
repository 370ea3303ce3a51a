// SPDX-License-Identifier: Apache-2.0
// Rule 10 of docs/arrival.md, make room in a passage. A robot A with its goal inside blocks robots
// that come near. A goes on before them, out of the passage, and enters again in turn. If robots of
// both directions are inside, A goes with the direction that goes on. Others take A for a robot of
// this direction, so none of them changes its decision. Where several robots rest at one goal, all
// of them must go, or the first one cannot.
#include <algorithm>
#include <optional>

#include "navigation/rules/passage_rules.h"

namespace avo::inline navigation {
namespace {

constexpr double kInARow = 2.2;  // for each robot that may stand between: the length of a row

// The number of others inside with the robot's goal.
double crowd_of(const Claimant& robot, std::span<const Claimant> claimants) {
  const auto is_of_it = [&](const Claimant& other) {
    return other.claim.inside && !(other.position == robot.position) && share_goal(robot, other);
  };
  return static_cast<double>(std::count_if(claimants.begin(), claimants.end(), is_of_it));
}

}  // namespace

Course make_room(const Passage& passage, const Claimant& robot, std::span<const Claimant> claimants,
                 double sensing_radius) {
  const double along = place_in(passage, robot.position).along;
  Foremost ahead, back;  // of the robots inside, by direction
  std::optional<bool> forward;
  double least = (kRestsNear + kInARow * crowd_of(robot, claimants)) * passage.radius;
  for (const Claimant& other : claimants) {
    if (!other.claim.moves || !senses(robot, other, sensing_radius)) continue;
    if (other.claim.inside) (other.claim.forward ? ahead : back).include(passage, other);
    const double behind = along - place_in(passage, other.position).along;
    const double between = other.claim.forward ? behind : -behind;
    if (between > 0.0 && between < least) least = between, forward = other.claim.forward;
  }
  if (!forward) return {};
  if (ahead.advance >= 0.0 && back.advance >= 0.0) forward = ahead.goes_on_before(back);
  return {.target = place_outside(passage, !*forward, robot.position)};
}

}  // namespace avo::inline navigation
