// SPDX-License-Identifier: Apache-2.0
// Rule 9 of docs/arrival.md, go back together. If robots of both directions are inside, all robots
// of one direction go back. It is the direction with the foremost robot that has come less far.
#include "navigation/rules/passage_rules.h"

namespace avo::inline navigation {

Course go_on_or_back(const Passage& passage, const Claimant& robot,
                     std::span<const Claimant> claimants, double sensing_radius) {
  Foremost ours, theirs;
  ours.include(passage, robot);
  for (const Claimant& other : claimants) {
    if (!other.claim.inside || !senses(robot, other, sensing_radius) ||
        rests_apart(passage, robot, other))
      continue;
    (other.claim.forward == robot.claim.forward ? ours : theirs).include(passage, other);
  }
  if (theirs.advance < 0.0 || ours.goes_on_before(theirs)) return {};
  return {.target = place_outside(passage, robot.claim.forward, robot.position)};
}

}  // namespace avo::inline navigation
