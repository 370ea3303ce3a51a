// SPDX-License-Identifier: Apache-2.0
// Rule 7 of docs/arrival.md, enter in turn. A robot may enter if no other robot comes towards it
// inside. Outside, no oncoming robot may be nearer to the mouth where it enters. A robot that rests
// farther inside does not come.
#include <algorithm>

#include "navigation/rules/passage_rules.h"

namespace avo::inline navigation {

bool may_enter(const Passage& passage, const Claimant& robot, std::span<const Claimant> claimants,
               double sensing_radius) {
  return std::none_of(claimants.begin(), claimants.end(), [&](const Claimant& other) {
    if (other.claim.forward == robot.claim.forward || !senses(robot, other, sensing_radius))
      return false;
    if (other.claim.inside) return !rests_apart(passage, robot, other);
    const double ours = robot.claim.distance, theirs = other.claim.distance;
    return theirs < ours || (theirs == ours && comes_first(other.position, robot.position));
  });
}

}  // namespace avo::inline navigation
