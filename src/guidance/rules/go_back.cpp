// SPDX-License-Identifier: Apache-2.0
// Rule 12 of docs/arrival.md, go back from a jam. Where there is no other route, some robots in a
// jam must go back, and only those at its ends can. All robots of a jam try to, for half of the
// time. A crowd before a passage of one lane is no jam: its robots wait in turn.
#include <cmath>

#include "core/plane.h"
#include "guidance/rules/held_passages.h"
#include "navigation/prospect.h"

namespace avo::inline guidance {
namespace {

constexpr double kSteadfast = 32.0;  // T: a jam that has lasted as long does not end by itself
// of a power of two: from there to the next power the robot goes on
constexpr double kForth = 0.75;

}  // namespace

bool goes_back(const Routes& routes, const Follower& robot, const Travel& travel) {
  const Waiting& waiting = travel.waiting;
  if (!travel.is_known() || waiting.looks_at < kInfinity || robot.rests) return false;
  const double waited = waiting.waited / (kSteadfast * unit_of_time(robot.traits));
  int power = 0;
  if (waited < 1.0 || std::frexp(waited, &power) >= kForth) return false;
  const Vec2 p = robot.as_seen.position;
  return gap_ahead(routes, travel, p) &&
         has_room_for_two(routes.passages, *travel.graph, *travel.map, p, travel.target);
}

}  // namespace avo::inline guidance
