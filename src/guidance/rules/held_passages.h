// SPDX-License-Identifier: Apache-2.0
// Another route where the passage on the route is held, or the route back (docs/arrival.md, rules
// 11 and 12).
#pragma once
#include <optional>

#include "guidance/follower.h"
#include "navigation/passages.h"

namespace avo::inline guidance {

/// For a robot that decides, with `left` m of its route left. If it has waited for longer than
/// another route takes in addition, it takes that route from the next step on. A passage that is
/// closed to it for this reason opens again once that makes no difference. time: s, that counts as
/// waiting. It is 0 while no robot is near, unless the robot goes back.
void go_around_held(const Routes& routes, const Follower& robot, double left, double time,
                    Travel& travel, LegScratch& scratch);

/// Returns whether the robot goes back for now, as far as others are near. The robot has then
/// waited for long before a passage of two lanes. There is no other route, and no passage of one
/// lane on the present one. After each power of two of that time the robot goes back for half of
/// the time that it has waited.
bool goes_back(const Routes& routes, const Follower& robot, const Travel& travel);

/// s, by which both rules measure how long a robot has waited: docs/arrival.md, "In open space".
double unit_of_time(const RobotTraits& traits);

/// The next gap ahead of a robot at p.
std::optional<Passages::Crossing> gap_ahead(const Routes& routes, const Travel& travel, Vec2 p);

/// Sets the heading of a robot at p that goes back: away from the old heading, or to its place
/// while it has no company.
inline void go_back(Vec2 p, bool in_company, Heading& heading) {
  heading.goal = in_company ? p - (heading.goal - p) : p;
  heading.yields = true, heading.guide = Guide::back;
}

}  // namespace avo::inline guidance
