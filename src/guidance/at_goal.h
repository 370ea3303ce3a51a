// SPDX-License-Identifier: Apache-2.0
// How a robot comes to rest near a goal on which others stand, or that others have as well
// (docs/arrival.md, rule 4).
#pragma once
#include <optional>
#include <span>

#include "guidance/places.h"
#include "guidance/travel.h"
#include "robots/motion.h"

namespace avo::inline guidance {

/// A robot that comes to its goal.
struct Comer {
  Vec2 position = {};  // m, of its disc
  Vec2 goal = {};      // m, of its disc, as the robot sees it
  Vec2 end = {};       // m, of its route
  Vec2 lost = {};      // m, the error of its own place
  double range = 0.0;  // m, see Seeker::range
};
/// heading: by its route, before the rules of passages.
Seeker seeker_of(const Comer& robot, const RobotTraits& traits, const Heading& heading);

/// What such a robot decides there, in place of any other decision.
struct AtSharedGoal {
  std::optional<Vec2> heads_for = {};  // m, target of its disc; none: where its route leads
  bool has_stood = false;              // the new value of Seeker::has_stood
  bool stops = false;                  // it brakes until it stands, and does not yield
};
/// Computes it for that robot as a seeker, from what it sees; sets Detour::goal_taken. It must come
/// to rest at a goal at which there may be no room for it.
AtSharedGoal at_shared_goal(const Seeker& seeker, Occupied& occupied, const Routes& routes,
                            std::span<const Wall> walls, Detour& detour);

/// The decision of a robot that stops.
Plan stop_of(const Planner& planner, const StepResponse& response, const Robot& robot);

}  // namespace avo::inline guidance
