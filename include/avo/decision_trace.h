// SPDX-License-Identifier: Apache-2.0
// How one decision came about: from the preferred velocity to the velocity after the step.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "avo/export.h"
#include "avo/planner.h"

namespace avo {

/// Where a robot wants to go first (docs/navigation.md, docs/arrival.md).
enum class Guide : std::uint8_t {
  route,    ///< to its goal, or to the next corner of its route around walls
  lane,     ///< to the right-hand lane of a passage of two lanes
  passage,  ///< where the right of way at a passage of one lane lets it go
  back,     ///< away from its goal, out of a jam
  mover,    ///< beside a mover at rest that stands on its goal
  place,    ///< to a place near its goal, which others share or stand on
  host,     ///< to what Simulation::set_preferred_velocity() says; nowhere before its start_time
};

/// The rule that made a wish of the preferred velocity: the last rule that changed it.
enum class WishRule : std::uint8_t {
  none,
  steers,       ///< a robot with wheels or wings turns first, or maneuvers
  keeps_right,  ///< in traffic
  yields,       ///< aside, for neighbors that are nearly in contact
  settles,      ///< in place near its goal, beside others
  leaves_wall,  ///< out of a wall that the robot is in
  in_cell,      ///< to the nearest point of its cell; method buffered_voronoi
};

/// What limits a decision: a neighbor, a wall, or the robot's own motion, where both are -1.
struct Cause {
  int neighbor = -1;  ///< index into the neighbors given
  int wall = -1;      ///< index into the walls given
  friend constexpr bool operator==(const Cause&, const Cause&) = default;
};

/// The stages of one decision, in their order; Planner::explain() fills them in. A stage that the
/// method does not have repeats the velocity of the stage before it.
struct DecisionTrace {
  Vec2 preferred_velocity;         ///< m/s, as given
  Vec2 wish;                       ///< m/s, that the rules for arriving made of it
  WishRule rule = WishRule::none;  ///< the rule that did
  /// index into the neighbors given: of those that the rule counts, the nearest ahead or the one
  /// that pushes most; -1: none
  int heeded = -1;
  Vec2 aim;  ///< m/s: the part of the wish for which the program was asked (docs/smoothness.md)
  /// [v'] m/s: what the program chose, Eq. (23); among movers alone Eq. (14)
  Vec2 target;
  /// The half-planes with the target on their lines, without repetition. Where it cannot keep to
  /// all, those that it misses by the most. Among movers alone, the movers with obstacles that
  /// contain the aim. Empty where the target is the aim.
  std::vector<Cause> binding;
  Vec2 proposal;  ///< m/s: the velocity after one step towards the target
  /// The neighbors and walls with constraints of the certificate that refuse the proposal, without
  /// repetition.
  std::vector<Cause> refusing;
  /// m/s: the velocity after the step that was asked for instead, where the route was blocked
  /// (docs/arrival.md, rule 3)
  std::optional<Vec2> detour;
  std::vector<Cause> refusing_detour;  ///< the constraints of the certificate that refuse it
  std::optional<Evasion>
      evasion;  ///< the evasive maneuver that was taken instead, see Plan::evading
  Plan plan;    ///< the decision: what Planner::plan() returns
};

AVO_API const char* to_string(Guide guide);
AVO_API const char* to_string(WishRule rule);

}  // namespace avo
