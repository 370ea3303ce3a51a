// SPDX-License-Identifier: Apache-2.0
// How one decision in space came about: from the preferred velocity to the velocity after the step.
#pragma once
#include <optional>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/space/planner.h"

namespace avo::space {

/// What limits a decision: a neighbor, a box, a moving obstacle, or the robot's own limits, where
/// all are -1.
struct Cause {
  int neighbor = -1;  ///< index into the neighbors given
  int box = -1;       ///< index into the boxes given
  int mover = -1;     ///< index into the moving obstacles given
  friend constexpr bool operator==(const Cause&, const Cause&) = default;
};

/// A half-space of v': normal · v' >= offset, Eqs. (15) to (20) in space.
struct CausedHalfSpace {
  Cause of;             ///< none: the robot's own climb or sink
  Vec3 normal = {};     ///< unit
  double offset = 0.0;  ///< m/s
};

/// The evasive maneuver that a robot beside moving obstacles takes in place of its target
/// (docs/space.md, "Moving obstacles"). The robot approaches a velocity, and then it brakes to
/// rest.
struct Evasion {
  /// index into the moving obstacles given: the one that made the robot reject its target; -1: no
  /// single one did
  int mover = -1;
  /// m/s, the velocity that the evasive maneuver approaches, or holds; 0: it brakes from the start
  Vec3 velocity = {};
  /// s, from the decision: the robot then brakes, if nothing else is decided
  double duration = 0.0;
};

/// The stages of one decision, in their order; space::Planner::explain() fills them in.
struct DecisionTrace {
  Vec3 preferred_velocity = {};    ///< m/s, as given
  Vec3 wish = {};                  ///< m/s, that the rules for arriving made of it
  WishRule rule = WishRule::none;  ///< the rule that did
  /// index into the neighbors given: of those that the rule counts, the nearest ahead or the one
  /// that pushes most; -1: none
  int heeded = -1;
  Vec3 aim = {};     ///< m/s: the part of the wish for which the program was asked
  Vec3 target = {};  ///< [v'] m/s: what the program chose, Eq. (23)
  /// Those that can cut into what the robot may choose. All others change nothing.
  std::vector<CausedHalfSpace> half_spaces;
  /// The half-spaces with the target on their boundaries, without repetition. Where it cannot keep
  /// to all, those that it misses by the most. Empty where the target is the aim.
  std::vector<Cause> binding;
  Vec3 proposal = {};  ///< m/s: the velocity after one step towards the target
  /// The neighbors, boxes and moving obstacles with constraints of the certificate that refuse the
  /// proposal, without repetition.
  std::vector<Cause> refusing;
  /// m/s: the velocity after the step that was asked for instead, where the route was blocked
  std::optional<Vec3> detour;
  std::vector<Cause> refusing_detour;  ///< those with constraints that refuse it
  /// the evasive maneuver that was taken instead, see Plan::evading
  std::optional<Evasion> evasion;
  Plan plan;  ///< the decision: what space::Planner::plan() returns
};

}  // namespace avo::space
